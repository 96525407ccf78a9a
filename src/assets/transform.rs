//! The transform of an object: scale, then rotate, then translate.

use glam::{DAffine3, DMat3, DVec3, EulerRot};

/// An affine map from the object space of a shape to the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transform(pub DAffine3);

impl Transform {
    /// Creates the map that scales by `scale` along the axes of the object, then rotates by `rotate`, then moves by `translate`.
    ///
    /// The factors of `scale` must not be 0. `rotate` is in degrees, about x, then y, then z of the scene; `translate` is in scene units.
    ///
    /// # Examples
    ///
    /// ```
    /// use bentray::glam::{DVec3, dvec3};
    /// use bentray::scene::Transform;
    ///
    /// let turned = Transform::new(DVec3::ONE, dvec3(0.0, 0.0, 90.0), dvec3(5.0, 0.0, 0.0));
    /// assert!(turned.0.transform_point3(DVec3::X).distance(dvec3(5.0, 1.0, 0.0)) < 1e-12);
    /// ```
    #[must_use]
    pub fn new(scale: DVec3, rotate: DVec3, translate: DVec3) -> Self {
        let turn = rotate * (std::f64::consts::PI / 180.0);
        // Intrinsic z·y·x is extrinsic x, y, z: the point is rotated about x first.
        let rotation = DMat3::from_euler(EulerRot::ZYX, turn.z, turn.y, turn.x);
        Self(DAffine3 { matrix3: rotation * DMat3::from_diagonal(scale), translation: translate })
    }

    /// Returns the factor of lengths if it is equal in all directions, so that spheres remain spheres.
    #[must_use]
    pub fn uniform_scale(&self) -> Option<f64> {
        let m = self.0.matrix3;
        let lengths = [m.x_axis.length(), m.y_axis.length(), m.z_axis.length()];
        lengths.iter().all(|l| (l - lengths[0]).abs() <= 1e-12 * lengths[0]).then_some(lengths[0])
    }

    /// Returns the factor of radii if circles around y remain circles around the image of y.
    #[must_use]
    pub fn round_scale(&self) -> Option<f64> {
        let [x, y, z] = [self.0.matrix3.x_axis, self.0.matrix3.y_axis, self.0.matrix3.z_axis];
        let square = |a: DVec3, b: DVec3| a.dot(b).abs() <= 1e-12 * a.length() * b.length();
        let same = (x.length() - z.length()).abs() <= 1e-12 * x.length();
        (same && square(x, y) && square(y, z) && square(z, x)).then_some(x.length())
    }
}
