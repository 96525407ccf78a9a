//! Cameras: how a point of the picture becomes a ray, for one eye or for two.
//!
//! *Practice.* [`KINDS`] names each kind once. The WGSL contract is `camera_ray(point)`. Adding one is a WGSL file, a file here
//! and a line of that table.

mod fisheye;
mod observer;
mod panorama;
mod pinhole;
mod plane;
mod read;
mod worldline;

use std::fmt;
use std::sync::Arc;

use glam::DVec3;

use super::same::same;
use super::{Binding, CameraFrame, Row, Same, row};
use crate::document::reader::TableReader;
use crate::document::{self, Kinds};

pub use fisheye::{Corners, Fisheye};
pub use observer::{frequency, observer};
pub use panorama::Panorama;
pub use pinhole::Pinhole;
pub use plane::Plane;
pub(crate) use read::read;
pub use worldline::{Event, NoPath, Path, fall};

/// Reads a camera; none if it cannot be used.
type Read = fn(&TableReader) -> Option<Arc<dyn Projection>>;
type Kind = document::Kind<Read>;

/// Every kind of camera. Adding one is a line here.
pub static KINDS: Kinds<Read> = Kinds {
    table: "camera",
    chooser: "kind",
    meaning: "projection: perspective, parallel, by the angle from the center of the image, or by longitude and \
              latitude",
    example: None,
    all: &[&pinhole::KIND, &plane::KIND, &fisheye::KIND, &panorama::KIND],
};

/// How a point of the picture becomes a ray.
pub trait Projection: fmt::Debug + Send + Sync + Same {
    /// Its WGSL part.
    fn part(&self) -> &'static str;

    /// Half of a view of so many pixels, to the right and upwards, in what its part multiplies these axes by.
    fn half_view(&self, pixels: [f64; 2]) -> [f64; 2];

    /// The members of `camera` that are its own, for a view of so many pixels.
    fn values(&self, pixels: [f64; 2]) -> Row {
        let _ = pixels;
        Row::new()
    }

    /// The angle of a pixel at the middle of a view of so many, in radians; none where pixels have no angle.
    fn pixel_angle(&self, pixels: [f64; 2]) -> Option<f64>;

    /// The WGSL part by which two eyes see the same at a distance.
    fn convergence_part(&self) -> &'static str {
        "camera/eyes/crossing_sphere"
    }

    /// Do its pictures have pixels that show nothing, so that its files carry alpha?
    fn is_transparent(&self) -> bool {
        false
    }

    /// Do all its rays start at one point?
    fn is_from_a_point(&self) -> bool {
        true
    }
}

same!(Projection);

/// `[camera]`.
#[derive(Debug, Clone)]
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
    pub projection: Arc<dyn Projection>,
    /// Whose directions the camera's are.
    pub frame: CameraFrame,
    /// t when the picture is taken.
    pub time: f64,
    /// Is light as bright as its shift makes it?
    pub shift: bool,
    /// And are colors taken for those of black bodies, which shift too?
    pub hues: bool,
    /// Two eyes, if the picture is a pair of views.
    pub stereo: Option<Stereo>,
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum StereoLayout {
    /// The left eye's at the left.
    SideBySide,
    /// The left eye's at the top.
    TopBottom,
}

impl Camera {
    /// At a position, looking at a point; none if that has no direction, or if `up` is along it.
    #[must_use]
    pub fn looking(position: DVec3, at: DVec3, up: DVec3, projection: Arc<dyn Projection>) -> Option<Self> {
        let forward = (at - position).try_normalize()?;
        let right = forward.cross(up).try_normalize()?;
        let frame = CameraFrame::Coordinate;
        Some(Self {
            position,
            forward,
            right,
            up: right.cross(forward),
            projection,
            frame,
            time: 0.0,
            shift: false,
            hues: false,
            stereo: None,
        })
    }

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

    /// Do all of its rays start at one place?
    #[must_use]
    pub fn is_at_one_place(&self) -> bool {
        self.projection.is_from_a_point() && self.stereo.is_none()
    }

    /// The angle of a pixel at the middle of a picture of so many, in radians; none where pixels have no angle.
    #[must_use]
    pub fn pixel_angle(&self, size: [u32; 2]) -> Option<f64> {
        self.projection.pixel_angle(self.view_size(size).map(f64::from))
    }

    /// What its WGSL parts are fed, for a picture of so many pixels.
    #[must_use]
    pub fn values(&self, size: [u32; 2]) -> Vec<Binding> {
        let pixels = self.view_size(size).map(f64::from);
        let [right, up] = self.projection.half_view(pixels);
        let axes = row! {
            position: Vec3(self.position),
            forward: Vec3(self.forward),
            right: Vec3(self.right * right),
            up: Vec3(self.up * up),
        };
        let camera = axes.into_iter().chain(self.projection.values(pixels)).collect();
        let eyes = self.stereo.map(|stereo| {
            let offset = row! { offset: Vec3(0.5 * stereo.separation * self.right) };
            let distance = stereo.convergence.map_or(Row::new(), |distance| row! { distance: Float(distance) });
            Binding::one("stereo", offset.into_iter().chain(distance).collect())
        });
        [Binding::one("camera", camera)].into_iter().chain(eyes).collect()
    }
}
