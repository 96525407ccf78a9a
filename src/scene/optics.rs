//! What light goes through: the law and the interiors together, for what neither can say alone.

use crate::document::reader::TableReader;
use crate::model::method::Demands;
use crate::model::{Camera, Law, Material, Medium, Object, Order};

use super::{Bound, Paths, Precision, Scene, Segment};

impl Scene {
    /// Returns `true` if light keeps the angular momentum that it has at the camera, about the law's axis, all along its way: no surface
    /// or interior deflects it, and it does not come to the bounding sphere in a straight line from outside.
    #[must_use]
    pub fn keeps_turning(&self, camera: &Camera) -> bool {
        let deflects = |object: &Object| {
            object.interior().is_some()
                || self.material_of(object).is_some_and(|material| material.surface.facts().deflects)
        };
        let Bound { radius, .. } = self.rays.bound;
        let centers = self.rays.bound.centers(Some(&*self.law));
        let is_within = centers.iter().any(|center| center.distance(camera.position) <= radius);
        (is_within || self.rays.asymptotic) && !self.objects.iter().any(deflects)
    }
}

/// As much of a scene as decides how its rays can be followed.
#[derive(Clone, Copy)]
pub(super) struct Optics<'a> {
    /// None if it cannot be used.
    pub law: Option<&'a dyn Law>,
    /// Those that can be used.
    pub objects: &'a [Object],
    /// Theirs.
    pub materials: &'a [Material],
    /// Does light go from surface to surface?
    pub paths: Option<Paths>,
}

impl Optics<'_> {
    fn interiors(&self) -> impl Iterator<Item = &dyn Medium> {
        self.objects.iter().filter_map(|object| Some(&*object.interior()?.medium))
    }

    /// Is there an opaque surface from which rays continue?
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

    /// Has some medium another index for each wavelength?
    pub fn disperses(&self) -> bool {
        self.media().any(|medium| medium.facts().is_dispersive)
    }

    /// Returns why some medium's index is not known for light of this wavelength, in nanometers.
    pub fn refuses_wavelength(&self, wavelength: f64) -> Option<String> {
        self.media().find_map(|medium| medium.refuses_wavelength(wavelength))
    }

    /// Is light bent anywhere?
    pub fn bends(&self) -> bool {
        self.law.is_none_or(|law| !law.facts().is_straight) || self.interiors().any(|medium| medium.facts().bends())
    }

    /// How far an arc's chords are from it, scene units, where the scene does not say, in a bounding sphere of this radius. A curve in
    /// closed form is cut where something is near, and nowhere else: there little is saved by a coarser one.
    pub fn arc_tolerance(&self, radius: f64) -> f64 {
        let part = if self.law.is_some_and(|law| law.facts().curve().is_some()) { 1e-7 } else { 1e-4 };
        // Of one between a throat and its sphere none may lead back.
        let throat = self.law.and_then(|law| law.facts().throat).map_or(f64::INFINITY, |throat| 0.1 * throat.depth);
        throat.min(part * radius)
    }

    /// What it demands of a method; `ends` where paths end at a given τ.
    pub fn demands(&self, ends: bool, has_chords: bool) -> Demands {
        let is_solved = |medium: &dyn Medium| medium.facts().closed_form(ends).is_none();
        let has_solved_interior = self.interiors().any(is_solved);
        let solved_law = |law: &dyn Law| match law.facts().medium() {
            // A spiral's closed form is for the inside of objects.
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

    /// What does not go with surfaces that rays continue from.
    pub fn check(&self, table: &TableReader, segment: Segment, asymptotic: bool, precision: Precision) {
        let has_interiors = self.interiors().next().is_some();
        if !has_interiors && !self.has_continuing_surface() {
            return;
        }
        if segment.has_chords() {
            let problem = "rays that go on from surfaces need arcs: a chord does not end on the path";
            table.fault(&["segment"], problem, "use segment = \"arc\"");
        }
        if asymptotic && has_interiors {
            let problem = "`sky_at_infinity` is for scenes without interiors";
            table.fault(&["sky_at_infinity"], problem, "leave it out");
        }
        if precision == Precision::Half {
            let problem = "16 bits are too few for rays that go on from surfaces";
            table.fault(&["precision"], problem, "use f32 or f64");
        }
        if let Some(problem) = self.law.and_then(|law| law.facts().refuses_surfaces(has_interiors)) {
            table.fault(&[], problem, "take the interiors and mirrors out of the scene, or change its law");
        }
    }
}
