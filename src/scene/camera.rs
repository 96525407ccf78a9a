//! Cameras as values: how a point of the picture becomes a ray, for one eye or for two.

use glam::DVec3;

/// `[camera]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Camera {
    /// Position, in scene units; of two eyes, halfway between them.
    pub position: DVec3,
    /// Unit vector into the picture.
    pub forward: DVec3,
    /// Unit vector to the picture's right.
    pub right: DVec3,
    /// Unit vector to the picture's top.
    pub up: DVec3,
    /// How a point of the picture becomes a ray.
    pub kind: CameraKind,
    /// Whose directions the camera's are.
    pub frame: Frame,
    /// Two eyes, if the picture is a pair of views.
    pub stereo: Option<Stereo>,
}

/// The projections.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CameraKind {
    /// All rays start at the position; `fov` is the vertical opening angle in degrees.
    Pinhole {
        /// Degrees, in (0, 180).
        fov: f64,
    },
    /// Rays start on a plane through the position, all in the direction `forward` (a flow takes its own direction).
    Plane {
        /// The plane's height in scene units; its width follows from the picture's shape.
        height: f64,
    },
    /// All rays start at the position; their angle from `forward` grows evenly with the distance from the picture's middle, to
    /// half of `fov` on the rim of a disk that touches the nearer edges.
    Fisheye {
        /// Degrees, above 0: more than 360 goes round again.
        fov: f64,
        /// What is outside the disk.
        corners: Corners,
    },
    /// All rays start at the position; longitude runs to the right and latitude upwards, as in an equirectangular sky.
    Panorama {
        /// Degrees from edge to edge: up to 360 across, up to 180 upwards.
        fov: [f64; 2],
    },
}

/// What a picture shows where its camera has no rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corners {
    /// Black.
    Black,
    /// Nothing: files then carry alpha.
    Transparent,
}

/// Whose unit directions the camera's are (Schwarzschild only; elsewhere both are the same).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Frame {
    /// Directions are coordinate directions (W04 §5.4).
    Coordinate,
    /// Directions are those that an observer at rest measures.
    Static,
}

/// `camera.stereo`: two eyes, one to the left and one to the right of the position, along the camera's `right`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stereo {
    /// From eye to eye, in scene units.
    pub separation: f64,
    /// Where the views are.
    pub layout: StereoLayout,
    /// The distance at which the views cross, in scene units: what is there has the same place in both. None for parallel views.
    pub convergence: Option<f64>,
}

/// Where the two views are in the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StereoLayout {
    /// The left eye's at the left.
    SideBySide,
    /// The left eye's at the top.
    TopBottom,
}

impl Camera {
    /// Where rays start: one place, or two.
    #[must_use]
    pub fn eyes(&self) -> Vec<DVec3> {
        match self.stereo {
            None => vec![self.position],
            Some(stereo) => [-0.5, 0.5].map(|part| self.position + part * stereo.separation * self.right).into(),
        }
    }

    /// The pixels of one view, of a picture of so many.
    #[must_use]
    pub fn view_size(&self, [width, height]: [u32; 2]) -> [u32; 2] {
        match self.stereo.map(|stereo| stereo.layout) {
            None => [width, height],
            Some(StereoLayout::SideBySide) => [width / 2, height],
            Some(StereoLayout::TopBottom) => [width, height / 2],
        }
    }

    /// Does a picture have pixels that show nothing, so that its files carry alpha?
    #[must_use]
    pub fn is_transparent(&self) -> bool {
        matches!(self.kind, CameraKind::Fisheye { corners: Corners::Transparent, .. })
    }

    /// The angle of a pixel at the middle of a picture of so many, in radians; a plane's pixels have none.
    #[must_use]
    pub fn pixel_angle(&self, size: [u32; 2]) -> Option<f64> {
        let [width, height] = self.view_size(size).map(f64::from);
        match self.kind {
            CameraKind::Pinhole { fov } => Some(2.0 * (0.5 * fov).to_radians().tan() / height),
            CameraKind::Plane { .. } => None,
            CameraKind::Fisheye { fov, .. } => Some(fov.to_radians() / width.min(height)),
            CameraKind::Panorama { fov: [across, upwards] } => {
                Some((across / width).min(upwards / height).to_radians())
            }
        }
    }
}
