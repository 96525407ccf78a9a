//! Scenes as plain values: the checked contents of a TOML file, with its meshes and images loaded.
//!
//! *Theory.* A scene consists of a law of light, a method that integrates rays, a camera, objects and a sky. Lengths are in scene units,
//! angles in degrees, colors linear, and G = c = 1.
//!
//! *Practice.* [`Scene::load`] reads a file in stages: `document` parses the TOML, with the location of every value in the file; `check`
//! converts documents to the values below and reports all errors in one run; `mesh` and `picture` load the files that the scene names.
//! Nothing here depends on a GPU.

mod build;
mod check;
mod emitters;
mod followed;
mod guide;
pub mod import;
mod impossible_matter;
mod lights;
mod optics;
mod output;
mod rays;
mod reference;
mod rounding;
mod shutter;
mod sky;
mod sky_cells;
mod stars;
mod surfaces;
mod throat;
mod vertex_colors;

#[cfg(test)]
mod tests;

pub use crate::assets::{
    Catalog, Curve, FanRay, Files, Formula, FormulaError, Function, Gltf, Graph, Id, Interval, LineElement, Mesh, Node,
    Picture, Profile, ProfilePoint, SampledGrid, Star, Transform, Variable, Vertex,
};
pub use crate::document::{ARCSECOND, Diagnostic, KeyReference, Override, SceneError, Units};
pub use crate::model::absorption::{Density, NoiseColoring, Texture};
pub use crate::model::cross_section::{CORNERS, CutPlane, Outline};
pub use crate::model::{
    Absorption, Camera, Control, Gloss, Interior, Law, Material, Medium, Method, Object, Observer, Pattern, Radiation,
    RigidMotion, Shape, Stereo, StereoLayout, Substance, Surface, Volume,
};
pub use emitters::Emitter;
pub use followed::{follow_as, followed_keys};
pub use guide::Beam;
pub use lights::{Light, LightGrid, LightSource, Shadows, TransparentShadows};
pub use output::{Output, Tonemap};
pub use rays::{Accelerate, Accuracy, Auto, Bound, PathTracing, Precision, Rays, Segment, Splitting};
pub use reference::{REFERENCE, TEMPLATES, Template, reference_markdown};
pub use sky::Sky;
pub use sky_cells::SkyCells;
pub use stars::Stars;

use std::sync::Arc;

use glam::DVec3;

use crate::model::Capture;
use crate::model::method::Demands;
use optics::Optics;

/// The height above a horizon at which rays through volumes end, as a fraction of its radius.
const ABOVE_HORIZON: f64 = 0.00125;

/// A whole scene: the complete and consistent values of one TOML file.
#[derive(Debug, Clone)]
pub struct Scene {
    /// The scale of the scene, if it has one.
    pub units: Option<Units>,
    /// The size and sampling of the image.
    pub image: Image,
    /// The camera; `None` is valid for `trace` alone.
    pub camera: Option<Camera>,
    /// The law of light.
    pub law: Arc<dyn Law>,
    /// The absorption and emission of space outside interiors.
    pub absorption: Option<Absorption>,
    /// The integration of rays.
    pub rays: Rays,
    /// The background of escaped rays.
    pub sky: Sky,
    /// The background on the other side of a wormhole; `None` if both sides have one sky.
    pub sky_other_side: Option<Sky>,
    /// The stars of the sky and of the sky on the other side of a wormhole.
    pub stars: [Option<Stars>; 2],
    /// The conversion of radiance to an image file.
    pub output: Output,
    /// The materials in the order of the file; [`Substance::Opaque`] is an index of this list.
    pub materials: Vec<Material>,
    /// The objects in the order of the file; the object id of every output is an index of this list.
    pub objects: Vec<Object>,
    /// The lights in the order of the file.
    pub lights: Vec<Light>,
    /// The volumes in the order of the file.
    pub volumes: Vec<Volume>,
    /// The frequencies of light; `None` if light has colors.
    pub radiation: Option<Radiation>,
    /// The ambient occlusion, if the scene uses it.
    pub occlusion: Option<Occlusion>,
    /// The animation, if the scene has one.
    pub animation: Option<Animation>,
    /// The images of materials and of the sky, each loaded once.
    pub pictures: Vec<Picture>,
    /// The unsupported contents of mesh files, such as lines; one sentence per file.
    pub left_out: Vec<String>,
}

/// The table `[image]`: size and sampling.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    /// The width and height in pixels.
    pub size: [u32; 2],
    /// The number of samples per pixel; for adaptive sampling the largest number.
    pub samples: u32,
    /// The distribution of several samples in a pixel.
    pub sampler: SamplePattern,
    /// The standard error of display values, from 0 to 1, at which an adaptive pixel stops; `None` without adaptive sampling.
    pub adaptive: Option<f64>,
    /// Is `true` if textures and patterns are averaged over pixel footprints.
    pub footprints: bool,
}

/// The distribution of samples over a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SamplePattern {
    /// A multi-jittered pattern, for a number of samples that is known beforehand.
    MultiJittered,
    /// A progressive pattern, which is well distributed after any power of two of samples.
    Progressive,
}

/// The table `[animation]`, whose values are in the scene of each frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Animation {
    /// The number of frames, counted from 0.
    pub frames: u32,
    /// The number of frames per second of a video.
    pub rate: f64,
    /// The fraction, 0 to 1, of the frame interval during which the shutter is open, starting at the frame's time.
    pub shutter: f64,
    /// The largest number of shutter samples of a frame, a power of two.
    pub moments: u32,
    /// The animated keys.
    pub keys: Vec<String>,
}

impl Scene {
    /// Returns `true` if light has a frequency for the observer at the camera.
    #[must_use]
    pub fn has_frequencies(&self) -> bool {
        self.has_frequencies_of(false)
    }

    /// Returns `true` if light has a frequency: for the observer at the camera, or if rays are given, for one at the start of each ray.
    #[must_use]
    pub fn has_frequencies_of(&self, is_given: bool) -> bool {
        let knows = |camera: &Camera| camera.observer != Observer::Coordinate && camera.is_at_one_place();
        let is_seen = is_given || self.camera.as_ref().is_some_and(knows);
        let is_seen = is_seen || self.radiation.is_some() && self.camera.as_ref().is_some_and(Camera::is_parallel);
        is_seen && !self.law.facts().momentum_parts.is_empty() && self.rays.path_tracing.is_none()
    }

    /// Returns the number of frequencies of light; 0 for colors.
    #[must_use]
    pub fn frequencies(&self) -> usize {
        self.radiation.as_ref().map_or(0, |radiation| radiation.frequencies.len())
    }

    /// Returns the required accuracy in radians, or `None` if the scene specifies a method. A pixel counts as a thousandth of a radian if
    /// there is no camera or the camera is orthographic, because its pixels have no angle.
    #[must_use]
    pub fn accuracy(&self) -> Option<f64> {
        Some(match self.rays.auto?.accuracy {
            Accuracy::Radians(angle) => angle,
            Accuracy::Pixels(part) => part * self.pixel_angle().unwrap_or(1e-3),
        })
    }

    /// Returns the moving objects with their indices in the file.
    pub fn travels(&self) -> impl Iterator<Item = (usize, &Object, &RigidMotion)> {
        let own = |(i, object): (usize, _)| -> Option<(usize, &Object, &RigidMotion)> {
            let object: &Object = object;
            Some((i, object, object.travel.as_ref()?))
        };
        self.objects.iter().enumerate().filter_map(own)
    }

    /// Returns the lower and upper corner of a bounding box of all positions of an object.
    #[must_use]
    pub fn swept(&self, object: &Object) -> (DVec3, DVec3) {
        let Some(travel) = &object.travel else { return object.bounds() };
        travel.swept(object.ball()).unwrap_or_else(|| {
            let Bound { radius, .. } = self.rays.bounding_sphere;
            let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
            let spheres = self.rays.bounding_sphere.centers(Some(&*self.law));
            spheres.iter().fold(nothing, |(lo, hi), center| (lo.min(center - radius), hi.max(center + radius)))
        })
    }

    /// Returns `true` if formulas of volumes use the coordinates of the law, which has a center or a line element, instead of those around
    /// their centers.
    #[must_use]
    pub fn places_volumes_by_law(&self) -> bool {
        let facts = self.law.facts();
        let has_own = self.law.equator().is_some() || facts.throat.is_some() || facts.line_element().is_some();
        has_own && !facts.momentum_parts.is_empty()
    }

    /// Returns the distance from the law's center within which there is matter; `None` if it is everywhere.
    #[must_use]
    pub fn matter_reach(&self) -> Option<f64> {
        if self.absorption.is_some() {
            return None;
        }
        let center = self.law.equator().map_or(DVec3::ZERO, |[center, _]| center);
        let reach = |volume: &Volume| {
            let [lo, hi] = volume.bounds()?;
            Some((hi - center).abs().max((lo - center).abs()).length())
        };
        self.volumes.iter().try_fold(0.0, |all: f64, volume| Some(all.max(reach(volume)?)))
    }

    /// Returns the intensity 1 in erg/(cm² s Hz sr), if the scene has units for it, or if all matter is black.
    #[must_use]
    pub fn intensity_unit(&self) -> Option<f64> {
        let radiation = self.radiation.as_ref()?;
        let by_emission = self.units.and_then(|units| radiation.unit(units.length?));
        let is_black = self.volumes.iter().all(|volume| volume.formulas.temperature.is_some());
        by_emission.or_else(|| radiation.planck_unit().filter(|_| is_black))
    }

    /// Returns every medium, of space and of objects.
    pub fn media(&self) -> impl Iterator<Item = &dyn Medium> {
        let interiors = self.objects.iter().filter_map(|object| Some(&object.interior()?.medium));
        self.law.facts().medium().into_iter().chain(interiors).map(|medium| &**medium)
    }

    /// Returns `true` if the index of a medium depends on wavelength.
    #[must_use]
    pub fn disperses(&self) -> bool {
        self.media().any(|medium| medium.facts().is_dispersive)
    }

    /// Returns the absorption of interiors and of space.
    pub fn absorptions(&self) -> impl Iterator<Item = &Absorption> {
        self.objects.iter().filter_map(|object| object.interior()?.absorption.as_deref()).chain(&self.absorption)
    }

    /// Returns `true` if arcs between the ends of a path are needed, for hits or for diagrams.
    #[must_use]
    pub fn needs_arcs(&self) -> bool {
        !self.objects.is_empty() || !self.rays.leaps
    }

    /// Returns the capture regions, which end rays that move inwards. They extend as far as `clearance`, the distance from a position to
    /// the nearest object, allows; with `None`, rays are followed as far as possible.
    #[must_use]
    pub fn captures(&self, clearance: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        let interiors = self.objects.iter().filter_map(|object| object.interior()?.medium.facts().capture);
        let shines =
            !self.volumes.is_empty() || self.absorption.as_ref().is_some_and(|own| own.emission != DVec3::ZERO);
        let law = match self.horizon().filter(|_| shines) {
            // Matter shines down to the horizon.
            Some(horizon) => {
                let is_double = self.rays.precision == Precision::Double;
                let above = ABOVE_HORIZON * if is_double { 0.01 } else { 1.0 };
                vec![Capture { radius: (1.0 + above) * horizon.radius, ..horizon }]
            }
            None => self.law.captures(clearance),
        };
        law.into_iter().chain(interiors).collect()
    }

    /// Returns the horizon of the law, if it is known.
    #[must_use]
    pub fn horizon(&self) -> Option<Capture> {
        let facts = self.law.facts();
        facts.below.map(|(_, horizon)| horizon).or(facts.swallows)
    }

    /// Returns `true` if the paths of a medium have a closed form, so that integration is optional.
    #[must_use]
    pub fn has_closed_forms(&self) -> bool {
        let ends = self.rays.max_parameter.is_some();
        let of_law = !self.law.facts().is_straight && self.law.facts().closed_form.is_some();
        of_law || self.media().map(Medium::facts).any(|medium| medium.bends() && medium.closed_form(ends).is_some())
    }

    /// Returns the demands of the scene on its integration method.
    #[must_use]
    pub fn demands(&self) -> Demands {
        let ends = self.rays.max_parameter.is_some();
        let paths = self.rays.path_tracing;
        Optics { law: Some(&*self.law), objects: &self.objects, materials: &self.materials, paths }
            .demands(ends, self.rays.segment.has_chords())
    }

    /// Returns the indices in the file of lights inside a capture region, such as a horizon. None of their light escapes where shadows are
    /// cast, and their color is black.
    #[must_use]
    pub fn swallowed_lights(&self) -> Vec<usize> {
        let captures = self.law.captures(None);
        let inside = |position: DVec3| captures.iter().any(|capture| capture.distance(position) <= 0.0);
        let swallowed = |light: &Light| match light.source {
            LightSource::Point(position) => light.shadows != Shadows::None && inside(position),
            LightSource::Directional(_) => false,
        };
        self.lights.iter().enumerate().filter(|(_, light)| swallowed(light)).map(|(i, _)| i).collect()
    }

    /// Returns messages about changes to meshes that define the inside for rays.
    #[must_use]
    pub fn mesh_remarks(&self) -> Vec<String> {
        let remark = |(i, object): (usize, &Object)| {
            let words = object.shape.mesh()?.remark()?;
            Some(format!("objects[{i}]: {words}"))
        };
        self.objects.iter().enumerate().filter_map(remark).collect()
    }

    /// Returns `true` if light propagates as in another scene, and guides paths as there, regardless of the sky and of colors that only the
    /// camera and the sky show.
    #[must_use]
    pub fn is_lit_as(&self, other: &Self) -> bool {
        *self.law == *other.law
            && self.absorption == other.absorption
            && self.volumes == other.volumes
            && self.rays == other.rays
            && self.materials == other.materials
            && self.objects == other.objects
            && self.lights == other.lights
            && (self.rays.path_tracing.is_none()
                || (self.beams() == other.beams() && self.guide_grid() == other.guide_grid()))
    }

    /// Returns the angle of a pixel at the image center, in radians.
    #[must_use]
    pub fn pixel_angle(&self) -> Option<f64> {
        self.camera.as_ref()?.pixel_angle(self.image.size)
    }

    /// Returns the angle that a pixel at the image center covers on the sky, as seen from `units.distance`, in radians.
    #[must_use]
    pub fn pixel_on_sky(&self) -> Option<f64> {
        Some(self.camera.as_ref()?.pixel_length(self.image.size)? * self.units?.angle()?)
    }

    /// Returns `true` if pixels of the image may be transparent, so that files have an alpha channel.
    #[must_use]
    pub fn is_transparent(&self) -> bool {
        self.sky == Sky::Transparent || self.camera.as_ref().is_some_and(|camera| camera.projection.is_transparent())
    }
}

/// The table `[ambient]`: ambient occlusion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Occlusion {
    /// Is `true` if occlusion rays follow the scene's law, which may bend them, instead of straight lines.
    pub along_law: bool,
    /// The distance beyond which objects do not occlude; unlimited if `None`.
    pub distance: Option<f64>,
    /// The fraction of ambient light at a fully occluded point.
    pub floor: f64,
    /// The effect of transparent objects.
    pub clear: TransparentShadows,
}
