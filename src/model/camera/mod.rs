//! Cameras, which map a point of the image to a ray, for one eye or two.
//!
//! *Practice.* [`KINDS`] lists each kind once. The WGSL contract is `camera_ray(point)`. To add a kind, add a WGSL file, a file here and a
//! line of that table.

mod fisheye;
mod observer;
mod panorama;
mod pinhole;
mod plane;
mod read;
mod worldline;

use std::fmt;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::dyn_eq::same;
use super::{Binding, DynEq, Observer, Row, row};
use crate::document::reader::TableReader;
use crate::document::{self, Kinds};

pub use fisheye::{Corners, Fisheye};
pub use observer::{frame, frequency, frequency_of_given, observer};
pub use panorama::Panorama;
pub use pinhole::Pinhole;
pub use plane::Plane;
pub(crate) use read::read;
pub use worldline::{Event, Path, WorldlineError, fall};

/// Reads a camera; returns `None` after an error.
type Read = fn(&TableReader) -> Option<Arc<dyn Projection>>;
type Kind = document::Kind<Read>;

/// The table of all cameras; a new kind needs one line here.
pub static KINDS: Kinds<Read> = Kinds {
    table: "camera",
    chooser: "kind",
    meaning: "projection: perspective, parallel, by the angle from the center of the image, or by longitude and \
              latitude",
    example: None,
    all: &[&pinhole::KIND, &plane::KIND, &fisheye::KIND, &panorama::KIND],
};

/// A projection, which maps a point of the image to a ray.
pub trait Projection: fmt::Debug + Send + Sync + DynEq {
    /// Returns the WGSL module.
    fn part(&self) -> &'static str;

    /// Returns half the extent of a view of `pixels` to the right and upwards, in the units by which its module scales these axes.
    fn half_view(&self, pixels: [f64; 2]) -> [f64; 2];

    /// Returns the members of `camera` that only this kind has, for a view of `pixels`.
    fn values(&self, pixels: [f64; 2]) -> Row {
        let _ = pixels;
        Row::new()
    }

    /// Returns the angle of a pixel at the center of a view of `pixels`, in radians, or `None` for parallel rays.
    fn pixel_angle(&self, pixels: [f64; 2]) -> Option<f64>;

    /// Returns the solid angle of a pixel of a view of `pixels` at `point` of the image plane, x to the right and y up, both in [−1, 1];
    /// `None` for parallel rays.
    fn solid_angle(&self, pixels: [f64; 2], point: DVec2) -> Option<f64>;

    /// Returns the length of a pixel at the center of a view of `pixels`, on the plane at this distance, in scene units; `None` if views
    /// are not planes.
    fn pixel_length(&self, pixels: [f64; 2], distance: f64) -> Option<f64> {
        let _ = (pixels, distance);
        None
    }

    /// Returns the WGSL module that makes the views of two eyes converge at a distance.
    fn convergence_part(&self) -> &'static str {
        "camera/eyes/crossing_sphere"
    }

    /// Returns `true` if images have pixels without content, so that files have an alpha channel.
    fn is_transparent(&self) -> bool {
        false
    }

    /// Returns `true` if all rays start at one point.
    fn is_from_a_point(&self) -> bool {
        true
    }
}

same!(Projection);

/// The table `[camera]`.
#[derive(Debug, Clone)]
pub struct Camera {
    /// The position, in scene units; for two eyes, halfway between them.
    pub position: DVec3,
    /// The unit vector into the image.
    pub forward: DVec3,
    /// The distance from the position to the point at the center of the image, in scene units.
    pub distance: f64,
    /// The unit vector to the image's right.
    pub right: DVec3,
    /// The unit vector to the image's top.
    pub up: DVec3,
    /// The projection.
    pub projection: Arc<dyn Projection>,
    /// The observer whose directions the camera uses.
    pub observer: Observer,
    /// The coordinate time t of the image.
    pub time: f64,
    /// Is `true` if the redshift changes the brightness of light.
    pub redshift: bool,
    /// Is `true` if the redshift also changes colors, which are treated as black-body colors.
    pub color_shift: bool,
    /// The pair of eyes of a stereo image; `None` for a single view.
    pub stereo: Option<Stereo>,
}

/// The table `camera.stereo`: two eyes, to the left and right of the position along the camera's `right`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stereo {
    /// The distance between the eyes, in scene units.
    pub separation: f64,
    /// The layout of the views.
    pub layout: StereoLayout,
    /// The distance at which points have equal positions in both views, in scene units; `None` for parallel views.
    pub convergence: Option<f64>,
}

/// The layout of two views in the image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum StereoLayout {
    /// The left eye's view at the left.
    SideBySide,
    /// The left eye's view at the top.
    TopBottom,
}

impl Camera {
    /// Creates a camera at `position` that looks at the point `at`, both in scene units; returns `None` if the points coincide, or if their
    /// direction is parallel to `up`.
    ///
    /// `up` may have any length above 0. The camera has one eye, time 0, coordinate directions and no redshift; its fields are public.
    ///
    /// # Examples
    ///
    /// ```
    /// use std::sync::Arc;
    ///
    /// use bentray::glam::{DVec3, dvec3};
    /// use bentray::model::camera::Pinhole;
    /// use bentray::scene::Camera;
    ///
    /// let lens = Arc::new(Pinhole { fov: 50.0 });
    /// let camera = Camera::look_at(dvec3(0.0, 0.0, 15.0), DVec3::ZERO, DVec3::Y, lens.clone());
    /// assert_eq!(camera.map(|camera| (camera.forward, camera.right)), Some((DVec3::NEG_Z, DVec3::X)));
    /// assert!(Camera::look_at(DVec3::Y, DVec3::ZERO, DVec3::Y, lens).is_none());
    /// ```
    #[must_use]
    pub fn look_at(position: DVec3, at: DVec3, up: DVec3, projection: Arc<dyn Projection>) -> Option<Self> {
        let forward = (at - position).try_normalize()?;
        let right = forward.cross(up).try_normalize()?;
        let frame = Observer::Coordinate;
        Some(Self {
            position,
            forward,
            distance: position.distance(at),
            right,
            up: right.cross(forward),
            projection,
            observer: frame,
            time: 0.0,
            redshift: false,
            color_shift: false,
            stereo: None,
        })
    }

    /// Returns the one or two positions from which rays start.
    #[must_use]
    pub fn eyes(&self) -> Vec<DVec3> {
        match self.stereo {
            None => vec![self.position],
            Some(stereo) => [-0.5, 0.5].map(|part| self.position + part * stereo.separation * self.right).into(),
        }
    }

    /// Returns the size in pixels of one view in an image of this size.
    #[must_use]
    pub fn view_size(&self, [width, height]: [u32; 2]) -> [u32; 2] {
        match self.stereo.map(|stereo| stereo.layout) {
            None => [width, height],
            Some(StereoLayout::SideBySide) => [width / 2, height],
            Some(StereoLayout::TopBottom) => [width, height / 2],
        }
    }

    /// Returns `true` if all rays start at one position.
    #[must_use]
    pub fn is_at_one_place(&self) -> bool {
        self.projection.is_from_a_point() && self.stereo.is_none()
    }

    /// Returns `true` if all rays have the same direction.
    #[must_use]
    pub fn is_parallel(&self) -> bool {
        !self.projection.is_from_a_point() && self.stereo.is_none()
    }

    /// Returns the angle of a pixel at the center of an image of this size, in radians, or `None` for parallel rays.
    #[must_use]
    pub fn pixel_angle(&self, size: [u32; 2]) -> Option<f64> {
        self.projection.pixel_angle(self.view_size(size).map(f64::from))
    }

    /// Returns the solid angle of a pixel `[column, row]` of an image of this size with a single view, in steradians; `None` for parallel rays.
    #[must_use]
    pub fn solid_angle(&self, size: [u32; 2], pixel: [u32; 2]) -> Option<f64> {
        let [pixels, [x, y]] = [size, pixel].map(|pair| pair.map(f64::from));
        let point = DVec2::new(2.0 * (x + 0.5) / pixels[0] - 1.0, 1.0 - 2.0 * (y + 0.5) / pixels[1]);
        self.projection.solid_angle(pixels, point)
    }

    /// Returns the length of a pixel at the center of an image of this size, on the plane through the point that the camera looks at, in
    /// scene units; `None` for a fisheye or a panorama.
    #[must_use]
    pub fn pixel_length(&self, size: [u32; 2]) -> Option<f64> {
        self.projection.pixel_length(self.view_size(size).map(f64::from), self.distance)
    }

    /// Returns the values of the WGSL modules, for an image of this size in pixels.
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
