//! The effect of a surface between two media on light.
//!
//! *Theory.* The component of n d along the surface is equal on both sides (Snell's law as a vector). Light is unpolarized: the reflectance
//! is the mean of the two Fresnel reflectances, s across and p in the plane of incidence.

use glam::DVec3;

/// The effect of a surface on a ray; directions are unit vectors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Interface {
    /// The media are equal: nothing happens.
    Matched,
    /// All light is reflected.
    Total {
        /// The direction of the reflected ray.
        reflected: DVec3,
    },
    /// The ray splits.
    Split {
        /// The direction of the reflected ray.
        reflected: DVec3,
        /// The direction of the transmitted ray.
        transmitted: DVec3,
        /// The reflected fraction of the light; the rest is transmitted.
        reflectance: f64,
    },
}

impl Interface {
    /// Computes the effect on a ray along `d` from the index `n1` to `n2`; `normal` is a unit vector to either side.
    pub fn new(n1: f64, n2: f64, d: DVec3, normal: DVec3) -> Self {
        if (n1 - n2).abs() <= 1e-6 * n1.max(n2) {
            return Self::Matched;
        }
        let reflected = mirrored(d, normal);
        // The normal against the ray.
        let normal = if d.dot(normal) > 0.0 { -normal } else { normal };
        let cos1 = -d.dot(normal);
        let along = n1 / n2 * (d + cos1 * normal);
        let sin2_squared = along.length_squared();
        if sin2_squared >= 1.0 {
            return Self::Total { reflected };
        }
        let cos2 = (1.0 - sin2_squared).sqrt();
        let s = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
        let p = (n2 * cos1 - n1 * cos2) / (n2 * cos1 + n1 * cos2);
        let transmitted = (along - cos2 * normal).normalize();
        Self::Split { reflected, transmitted, reflectance: f64::midpoint(s * s, p * p) }
    }
}

/// Returns the direction of the mirror image of a ray along `d`.
pub fn mirrored(d: DVec3, normal: DVec3) -> DVec3 {
    (d - 2.0 * d.dot(normal) * normal).normalize()
}
