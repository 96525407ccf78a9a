//! Optical properties that depend on both the law and the interiors.

use glam::DVec3;

use crate::document::reader::TableReader;
use crate::model::method::Demands;
use crate::model::{Camera, Law, Material, Medium, Object, Order};

use super::{Bound, PathTracing, Precision, Scene, Segment, Shadows};

impl Scene {
    /// Returns `true` if light conserves its angular momentum around the law's axis along its whole path from the camera: no surface or
    /// interior deflects it, and it does not reach the bounding sphere in a straight line from outside.
    #[must_use]
    pub fn keeps_turning(&self, camera: &Camera) -> bool {
        let Bound { radius, .. } = self.rays.bounding_sphere;
        let centers = self.rays.bounding_sphere.centers(Some(&*self.law));
        let is_within = centers.iter().any(|center| center.distance(camera.position) <= radius);
        (is_within || self.rays.sky_at_infinity) && !self.deflects()
    }

    /// Returns why the ends of an image's paths cannot be stored and shaded later, if this is so.
    #[must_use]
    pub fn refuses_map(&self) -> Option<&'static str> {
        let along_law = self.is_occluded() && self.occlusion.is_some_and(|occlusion| occlusion.along_law);
        [
            (self.rays.path_tracing.is_some(), "a lens map cannot be combined with lighting = \"path-tracing\""),
            (self.image.adaptive.is_some(), "a lens map cannot be combined with image.adaptive"),
            (self.rays.precision == Precision::Double, "a lens map has 32 bits; set rays.precision = \"f32\""),
            (
                self.absorptions().any(|filter| filter.emission != DVec3::ZERO),
                "a lens map has only the ends of rays, and no media that emit light along them",
            ),
            (!self.volumes.is_empty(), "a lens map has only the ends of rays, and no volumes along them"),
            (
                self.has_shadows(Shadows::Shooting) || along_law,
                "a lens map cannot be combined with shadows or ambient occlusion along the law, which need other rays",
            ),
            (
                self.travels().next().is_some(),
                "a lens map cannot be combined with moving objects, whose surfaces depend on the time of each ray",
            ),
        ]
        .into_iter()
        .find_map(|(is_so, problem)| is_so.then_some(problem))
    }

    /// Returns `true` if a key of the scene file changes only how the ends of rays look, and not which rays are followed.
    #[must_use]
    pub fn is_look(&self, key: &str) -> bool {
        const TABLES: [&str; 5] = ["sky", "output", "lights", "ambient", "units"];
        const KEYS: [&str; 3] = ["camera.redshift", "camera.color_shift", "image.footprints"];
        if let Some((name, own)) = key.strip_prefix("materials.").and_then(|rest| rest.split_once('.')) {
            let ends = |material: &Material| material.name == name && !material.surface.facts().continues;
            return self.materials.iter().any(ends) && !["kind", "opacity"].contains(&own);
        }
        KEYS.contains(&key) || TABLES.contains(&key.split('.').next().unwrap_or_default())
    }

    /// Returns `true` if a surface or an interior changes the direction of rays.
    #[must_use]
    pub fn deflects(&self) -> bool {
        let deflects = |object: &Object| {
            object.interior().is_some()
                || self.material_of(object).is_some_and(|material| material.surface.facts().deflects)
        };
        self.objects.iter().any(deflects)
    }
}

/// The part of a scene that determines how its rays can be integrated.
#[derive(Clone, Copy)]
pub(super) struct Optics<'a> {
    /// The law; `None` after an error.
    pub law: Option<&'a dyn Law>,
    /// The objects without errors.
    pub objects: &'a [Object],
    /// The materials of the objects.
    pub materials: &'a [Material],
    /// The settings of path tracing, if the scene uses it.
    pub paths: Option<PathTracing>,
}

impl Optics<'_> {
    fn interiors(&self) -> impl Iterator<Item = &dyn Medium> {
        self.objects.iter().filter_map(|object| Some(&*object.interior()?.medium))
    }

    /// Returns `true` if rays continue from an opaque surface.
    fn has_continuing_surface(&self) -> bool {
        if self.paths.is_some() {
            return !self.objects.is_empty();
        }
        let continues = |material: usize| {
            self.materials.get(material).is_some_and(|m| m.surface.facts().continues || m.surface.facts().opacity < 1.0)
        };
        self.objects.iter().filter_map(Object::material).any(continues)
    }

    fn media(&self) -> impl Iterator<Item = &dyn Medium> {
        let of_law = self.law.and_then(|law| law.facts().medium());
        of_law.into_iter().map(|medium| &**medium).chain(self.interiors())
    }

    /// Returns `true` if the index of a medium depends on wavelength.
    pub fn disperses(&self) -> bool {
        self.media().any(|medium| medium.facts().is_dispersive)
    }

    /// Returns why the index of some medium is unknown for this wavelength, in nanometers.
    pub fn refuses_wavelength(&self, wavelength: f64) -> Option<String> {
        self.media().find_map(|medium| medium.refuses_wavelength(wavelength))
    }

    /// Returns `true` if light is bent anywhere.
    pub fn bends(&self) -> bool {
        self.law.is_none_or(|law| !law.facts().is_straight) || self.interiors().any(|medium| medium.facts().bends())
    }

    /// Returns the default distance of an arc from its chords, in scene units, for a bounding sphere of this radius. A closed-form curve is
    /// subdivided only near objects, so that a coarser tolerance saves little time.
    pub fn arc_tolerance(&self, radius: f64) -> f64 {
        let part = if self.law.is_some_and(|law| law.facts().curve().is_some()) { 1e-7 } else { 1e-4 };
        // No chord of an arc between a throat and its sphere may cross the throat again.
        let throat = self.law.and_then(|law| law.facts().throat).map_or(f64::INFINITY, |throat| 0.1 * throat.depth);
        throat.min(part * radius)
    }

    /// Returns the demands on a method; `ends` is `true` if paths end at a given τ.
    pub fn demands(&self, ends: bool, has_chords: bool) -> Demands {
        let is_solved = |medium: &dyn Medium| medium.facts().closed_form(ends).is_none();
        let has_solved_interior = self.interiors().any(is_solved);
        let solved_law = |law: &dyn Law| match law.facts().medium() {
            // A spiral's closed form is only for the inside of objects.
            Some(medium) => medium.facts().closed_form(ends).is_none_or(|form| form.meets_obstacles),
            None => law.facts().closed_form.is_none(),
        };
        let fills_space = self.law.is_some_and(|law| law.facts().medium().is_some());
        Demands {
            order: self.law.map_or(Order::Place, |law| law.facts().order),
            has_plane: self.law.is_none_or(|law| law.facts().orbit.is_some_and(|orbit| orbit.is_plane())),
            separates: self.law.is_none_or(|law| law.facts().orbit.is_some_and(|orbit| !orbit.is_plane())),
            needs_solver: has_solved_interior || self.law.is_some_and(solved_law),
            has_solved_interior,
            has_medium: fills_space || self.interiors().any(|medium| medium.facts().bends()),
            ends,
            has_chords,
        }
    }

    /// Reports settings that conflict with surfaces from which rays continue.
    pub fn check(&self, table: &TableReader, segment: Segment, asymptotic: bool, precision: Precision) {
        let has_interiors = self.interiors().next().is_some();
        if !has_interiors && !self.has_continuing_surface() {
            return;
        }
        if segment.has_chords() {
            let problem = "rays that continue at a surface require arcs, because a chord does not end on the path";
            table.fault(&["segment"], problem, "use segment = \"arc\"");
        }
        if asymptotic && has_interiors {
            let problem = "`sky_at_infinity` cannot be combined with interiors";
            table.fault(&["sky_at_infinity"], problem, "remove it");
        }
        if precision == Precision::Half {
            let problem = "16-bit state is too imprecise for rays that continue at a surface";
            table.fault(&["precision"], problem, "use f32 or f64");
        }
        if let Some(problem) = self.law.and_then(|law| law.facts().refuses_surfaces(has_interiors)) {
            table.fault(&[], problem, "remove the interiors and mirrors, or use another law");
        }
    }
}
