//! Volumes: matter that emits and absorbs light along the path of a ray, as it moves.
//!
//! *Theory.* In vacuum I/ν³ is constant along a ray. Matter with the four-velocity u receives light of frequency sν, adds j(sν)/s² and takes
//! s κ(sν) per unit of the affine parameter in which light has frequency 1 at the camera. Coefficients of overlapping volumes add.
//!
//! *Practice.* `shaders/volume/transfer.wgsl` integrates this along steps of any motion; the program's generator writes the formulas of the
//! scene's volumes. Without `[radiation]`, the channels are red, green and blue, and formulas cannot depend on the frequency.

mod grids;
mod radiation;
mod read;

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::shape::Shape;
use super::{Binding, Observer, Row, row};
use crate::assets::{SampledGrid, Transform, VolumeFormulas};

pub use grids::bindings as grids;
pub use radiation::{MOST_FREQUENCIES, Radiation, Show};
pub(crate) use read::{read, reference};

/// A region with matter that emits and absorbs light.
#[derive(Debug, Clone, PartialEq)]
pub struct Volume {
    /// The shape and its placement; `None` for all of space.
    pub region: Option<VolumeRegion>,
    /// The density, the emission, the absorption, the motion, and the scale.
    pub formulas: VolumeFormulas,
    /// The kind of motion.
    pub flow: Flow,
    /// The temperature in kelvins of the black body that has luminance 1 in color.
    pub white: f64,
    /// The grids of its formulas, in the order of their variables.
    pub grids: Vec<Arc<SampledGrid>>,
}

/// The region of a volume.
#[derive(Debug, Clone)]
pub struct VolumeRegion {
    /// The shape, which has a norm.
    pub shape: Arc<dyn Shape>,
    /// The placement.
    pub transform: Transform,
    /// The name of the shape in WGSL: `norm_SHAPE` in `shaders/volume/region.wgsl`.
    pub name: &'static str,
}

impl PartialEq for VolumeRegion {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.transform == other.transform
    }
}

/// The motion of matter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Flow {
    /// The motion of an observer at the same position.
    Observer(Observer),
    /// Around the law's axis with a formula of l, its angular momentum divided by its energy.
    AngularMomentum,
    /// Around the law's axis with a formula of Ω = dφ/dt.
    AngularVelocity,
    /// Relative to the Eulerian observer, with formulas of three coordinate components, whose length is the speed.
    Velocity,
}

impl Volume {
    /// Returns the position of the region's center.
    #[must_use]
    pub fn center(&self) -> DVec3 {
        self.region.as_ref().map_or(DVec3::ZERO, |region| region.transform.0.translation)
    }

    /// Returns `true` for positions in the region.
    #[must_use]
    pub fn contains(&self, x: DVec3) -> bool {
        let own = |region: &VolumeRegion| region.transform.0.inverse().transform_point3(x);
        self.region.as_ref().is_none_or(|region| region.shape.contains(own(region)))
    }

    /// Returns the lower and upper corner of a box around the region; `None` for all of space.
    #[must_use]
    pub fn bounds(&self) -> Option<[DVec3; 2]> {
        let region = self.region.as_ref()?;
        let axes = region.transform.0.matrix3;
        // A norm is at least the largest coordinate.
        let half = axes.x_axis.abs() + axes.y_axis.abs() + axes.z_axis.abs();
        let center = region.transform.0.translation;
        Some([center - half, center + half])
    }

    /// Returns the members of its entry in `volumes`; formulas have their origin at `origin`.
    #[must_use]
    pub fn values(&self, origin: DVec3) -> Row {
        let Some(region) = &self.region else {
            let none = DVec4::ZERO;
            return row! { x: Vec4(none), y: Vec4(none), z: Vec4(none), least: Float(1.0), origin: Vec3(origin) };
        };
        let inverse = region.transform.0.inverse();
        let [x, y, z] = inverse.matrix3.transpose().to_cols_array_2d().map(DVec3::from_array);
        let at = inverse.translation;
        let least = 1.0 / x.length().max(y.length()).max(z.length());
        row! {
            x: Vec4(x.extend(at.x)),
            y: Vec4(y.extend(at.y)),
            z: Vec4(z.extend(at.z)),
            least: Float(least),
            origin: Vec3(origin),
        }
    }
}

/// Returns the binding of the regions.
#[must_use]
pub fn regions(volumes: &[Volume], origin: impl Fn(&Volume) -> DVec3) -> Binding {
    Binding::list("volumes", volumes.iter().map(|volume| volume.values(origin(volume))).collect())
}
