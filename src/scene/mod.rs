//! Scenes as plain values: what a TOML file says, checked, with its meshes and pictures loaded.
//!
//! *Theory.* A scene is a law of light, a way to follow it, a camera, things to hit and a sky to escape to. Lengths
//! are in scene units, angles in degrees, colors linear, G = c = 1.
//!
//! *Practice.* [`Scene::load`] reads a file in three steps: `document` (the TOML as written, every value with its place in
//! the file), then `check` (documents to the values below, all mistakes found in one run), with `mesh` and
//! `picture` loading what the file names. Nothing here knows of a GPU.

mod build;
mod check;
mod followed;
mod guide;
pub mod import;
mod lamps;
mod lights;
mod optics;
mod output;
mod rays;
mod reference;
mod rounding;
mod shutter;
mod sky;
mod sky_cells;
mod surfaces;
mod throat;
mod vertex_colors;

#[cfg(test)]
mod tests;

pub use crate::assets::{
    Curve, FanRay, Files, Formula, FormulaError, Function, Gltf, Graph, Id, IndexGrid, Interval, LineElement, Mesh,
    Node, Picture, Profile, ProfilePoint, Transform, Variable, Vertex,
};
pub use crate::document::{KeyReference, Mistake, Override, SceneError};
pub use crate::model::cut::{CORNERS, CutPlane, Outline};
pub use crate::model::filter::{Density, Look, Texture};
pub use crate::model::{
    Camera, CameraFrame, Control, Filter, Gloss, Interior, Law, Material, Medium, Method, Object, Pattern, Shape,
    Stereo, StereoLayout, Substance, Surface, Travel,
};
pub use followed::{follow_as, followed_keys};
pub use guide::Beam;
pub use lamps::Lamp;
pub use lights::{Clear, Light, LightGrid, LightSource, Shadows};
pub use output::{Output, Tonemap};
pub use rays::{Accelerate, Accuracy, Auto, Bound, Branches, Paths, Precision, Rays, Segment};
pub use reference::{REFERENCE, TEMPLATES, Template, reference_markdown};
pub use sky::Sky;
pub use sky_cells::SkyCells;

use std::sync::Arc;

use glam::DVec3;

use crate::model::Capture;
use crate::model::method::Demands;
use optics::Optics;

/// A whole scene: the values of one TOML file, complete and consistent.
#[derive(Debug, Clone)]
pub struct Scene {
    /// What the picture is.
    pub image: Image,
    /// Where rays start; a scene made only for `trace` may have none.
    pub camera: Option<Camera>,
    /// How light travels.
    pub law: Arc<dyn Law>,
    /// What space takes from light on its way, or adds to it, where no interior is.
    pub filter: Option<Filter>,
    /// How light is followed.
    pub rays: Rays,
    /// What an escaped ray sees.
    pub sky: Sky,
    /// What one sees that escaped on the other side of a wormhole; none where both sides have the same sky.
    pub beyond: Option<Sky>,
    /// How radiance becomes a picture file.
    pub output: Output,
    /// In the order of the file; [`Substance::Opaque`] indexes it.
    pub materials: Vec<Material>,
    /// In the order of the file; the object id of every output is the index here.
    pub objects: Vec<Object>,
    /// In the order of the file.
    pub lights: Vec<Light>,
    /// How ambient light is shut out, if it is.
    pub occlusion: Option<Occlusion>,
    /// What changes from frame to frame, if anything does.
    pub animation: Option<Animation>,
    /// Every picture that a material or the sky uses, each loaded once.
    pub pictures: Vec<Picture>,
    /// What the scene's meshes have that is not drawn, such as lines: a sentence for each file.
    pub left_out: Vec<String>,
}

/// `[image]`: size and sampling.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Rays per pixel; under adaptive sampling the most that one takes of its own.
    pub samples: u32,
    /// Where in a pixel they are, if there are several.
    pub pattern: SamplePattern,
    /// Does a pixel stop when its mean is good enough? The standard error at which it is, in what a screen shows, from 0 to 1.
    pub adaptive: Option<f64>,
    /// Are pictures and patterns averaged over what a pixel sees of them?
    pub footprints: bool,
}

/// How samples are spread over a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SamplePattern {
    /// For a number that is known beforehand.
    MultiJittered,
    /// Well spread after any power of two of them.
    Progressive,
}

/// `[animation]`: its values are in the scene of each frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Animation {
    /// How many frames there are, counted from 0.
    pub frames: u32,
    /// How many of them a film shows in a second.
    pub rate: f64,
    /// The part of the time between two frames for which the shutter is open, from a frame's own time on: 0 to 1.
    pub shutter: f64,
    /// Moments that a frame shows then, at most: a power of two.
    pub moments: u32,
    /// What it moves.
    pub keys: Vec<String>,
}

impl Scene {
    /// Has light a frequency to whoever is at the camera?
    #[must_use]
    pub fn has_frequencies(&self) -> bool {
        let knows = |camera: &Camera| camera.frame != CameraFrame::Coordinate && camera.is_at_one_place();
        let is_seen = self.camera.as_ref().is_some_and(knows);
        is_seen && !self.law.facts().momentum_parts.is_empty() && self.rays.paths.is_none()
    }

    /// The accuracy that the scene asks for, in radians; none if it names a method. A plane camera's pixels have no angle:
    /// there, and without a camera, a pixel is a thousandth of a radian.
    #[must_use]
    pub fn accuracy(&self) -> Option<f64> {
        Some(match self.rays.auto?.accuracy {
            Accuracy::Radians(angle) => angle,
            Accuracy::Pixels(part) => part * self.pixel_angle().unwrap_or(1e-3),
        })
    }

    /// The objects that move, by their places in the file.
    pub fn travels(&self) -> impl Iterator<Item = (usize, &Object, &Travel)> {
        let own = |(i, object): (usize, _)| -> Option<(usize, &Object, &Travel)> {
            let object: &Object = object;
            Some((i, object, object.travel.as_ref()?))
        };
        self.objects.iter().enumerate().filter_map(own)
    }

    /// A box about all places that an object comes to: lower and upper corner.
    #[must_use]
    pub fn swept(&self, object: &Object) -> (DVec3, DVec3) {
        let Some(travel) = &object.travel else { return object.bounds() };
        travel.swept(object.ball()).unwrap_or_else(|| {
            let Bound { radius, .. } = self.rays.bound;
            let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
            let spheres = self.rays.bound.centers(Some(&*self.law));
            spheres.iter().fold(nothing, |(lo, hi), center| (lo.min(center - radius), hi.max(center + radius)))
        })
    }

    /// Every medium: of all space, and of objects.
    pub fn media(&self) -> impl Iterator<Item = &dyn Medium> {
        let interiors = self.objects.iter().filter_map(|object| Some(&object.interior()?.medium));
        self.law.facts().medium().into_iter().chain(interiors).map(|medium| &**medium)
    }

    /// Has some medium another index for each wavelength?
    #[must_use]
    pub fn disperses(&self) -> bool {
        self.media().any(|medium| medium.facts().is_dispersive)
    }

    /// Every filter that light passes: of interiors, and of space.
    pub fn filters(&self) -> impl Iterator<Item = &Filter> {
        self.objects.iter().filter_map(|object| object.interior()?.filter.as_deref()).chain(&self.filter)
    }

    /// Does something ask where a path is between its ends: what it may hit, what filters its light, or who draws it?
    #[must_use]
    pub fn needs_arcs(&self) -> bool {
        !self.objects.is_empty() || self.filter.is_some() || !self.rays.leaps
    }

    /// Where rays that move inwards end: as far out as `clearance` allows, the distance from a place to the nearest object; none
    /// where rays are to be followed as far as they go.
    #[must_use]
    pub fn captures(&self, clearance: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        let interiors = self.objects.iter().filter_map(|object| object.interior()?.medium.facts().capture);
        self.law.captures(clearance).into_iter().chain(interiors).collect()
    }

    /// Is there a medium whose paths have a closed form, or may be integrated as well?
    #[must_use]
    pub fn has_closed_forms(&self) -> bool {
        let ends = self.rays.length.is_some();
        let of_law = !self.law.facts().is_straight && self.law.facts().closed_form.is_some();
        of_law || self.media().map(Medium::facts).any(|medium| medium.bends() && medium.closed_form(ends).is_some())
    }

    /// What it demands of the method that follows its rays.
    #[must_use]
    pub fn demands(&self) -> Demands {
        let ends = self.rays.length.is_some();
        let paths = self.rays.paths;
        Optics { law: Some(&*self.law), objects: &self.objects, materials: &self.materials, paths }
            .demands(ends, self.rays.segment.has_chords())
    }

    /// Lights inside of what captures rays, such as a horizon: none of their light comes out where shadows are cast, and their color is
    /// black. By their places in the file.
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

    /// What was changed about meshes so that rays know what is inside of them, in words for a user.
    #[must_use]
    pub fn mesh_remarks(&self) -> Vec<String> {
        let remark = |(i, object): (usize, &Object)| {
            let words = object.shape.mesh()?.remark()?;
            Some(format!("object {i} (from 0): {words}"))
        };
        self.objects.iter().enumerate().filter_map(remark).collect()
    }

    /// Does light from the lights go where it goes in another scene? The camera, the sky and colors that show only there do not matter.
    #[must_use]
    pub fn is_lit_as(&self, other: &Self) -> bool {
        *self.law == *other.law
            && self.filter == other.filter
            && self.rays == other.rays
            && self.materials == other.materials
            && self.objects == other.objects
            && self.lights == other.lights
    }

    /// The angle of a pixel at the picture's center, in radians.
    #[must_use]
    pub fn pixel_angle(&self) -> Option<f64> {
        self.camera.as_ref()?.pixel_angle(self.image.size)
    }

    /// Returns `true` if pixels of its picture may show nothing, so that its files carry alpha.
    #[must_use]
    pub fn is_transparent(&self) -> bool {
        self.sky == Sky::Transparent || self.camera.as_ref().is_some_and(|camera| camera.projection.is_transparent())
    }
}

/// `[ambient]`: how much of ambient light reaches a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Occlusion {
    /// Is it looked along the scene's law, which may bend what a place sees, or along straight lines?
    pub along_law: bool,
    /// What is farther shuts nothing out; without one all does.
    pub distance: Option<f64>,
    /// The part that is left where all is closed.
    pub floor: f64,
    /// What clear things do to it.
    pub clear: Clear,
}
