//! Regions: the space outside all objects, and the inside of each object that light passes through.
//!
//! *Theory.* Each *kind* of region has a motion, the cheapest that is correct for its medium, and a copy of the
//! modules that follow rays; regions of one kind differ only in numbers. If several objects overlap, the object with
//! the highest priority wins, and among equal priorities the smallest object. The objects are numbered in that order,
//! a ray stores the set of objects that it is in as bits, and the lowest bit is the medium around it. Closed mirrors
//! have bits too, after all others: they have no medium, but the bit states from which side a ray meets them.

use std::sync::Arc;

use glam::DVec3;

use super::shared_surfaces::Touching;
use crate::model::method::Path;
use crate::model::{ClosedForm, Medium, STRAIGHT, Wgsl, medium};
use crate::scene::{Object, Scene};

/// The motion of rays in a region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// The scene's law, with its method.
    Law,
    /// A closed form.
    Closed(&'static ClosedForm),
    /// The scene's method, with the refractive index of the medium.
    Solved,
}

impl Motion {
    /// Returns the closed form, if the motion has one.
    #[must_use]
    pub fn closed_form(self) -> Option<&'static ClosedForm> {
        match self {
            Self::Closed(form) => Some(form),
            Self::Law | Self::Solved => None,
        }
    }
}

/// A kind of region.
#[derive(Debug, Clone)]
pub struct RegionKind {
    /// The motion of its rays.
    pub motion: Motion,
    /// Whether one step crosses the whole region, because it contains nothing else.
    pub leaps: bool,
    /// The modules for its refractive index; `None` for laws without one.
    pub index: Option<Vec<Wgsl>>,
    /// The media of the regions of this kind, in the order of `Region::place`.
    pub media: Vec<Arc<dyn Medium>>,
}

impl RegionKind {
    /// Returns `true` if its segments are straight, or are not tested at all.
    #[must_use]
    pub fn is_line(&self) -> bool {
        self.leaps || self.motion.closed_form().is_some_and(|form| form.is_line)
    }
}

/// An object with an inside and an outside that rays can be on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Region {
    /// The index into the scene's objects.
    pub object: usize,
    /// The index into the kinds; `None` for mirrors, which have no medium.
    pub kind: Option<usize>,
    /// The index of the medium in that kind.
    pub place: usize,
    /// The radius of the largest sphere around the medium's center inside the object; a leap ends on it.
    pub radius: f64,
}

/// A bounding sphere of an obstacle to spirals in an inverse-r medium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Obstacle {
    /// The index of the medium in its kind.
    pub place: usize,
    /// The center of the sphere.
    pub center: DVec3,
    /// The radius of the sphere.
    pub radius: f64,
}

/// All regions of a scene.
#[derive(Debug, Clone, Default)]
pub struct Regions {
    /// The kinds of regions; the first is the space outside.
    pub kinds: Vec<RegionKind>,
    /// The regions by bit.
    pub regions: Vec<Region>,
    /// The obstacles to spirals.
    pub obstacles: Vec<Obstacle>,
    /// The objects whose surfaces touch others.
    pub touching: Touching,
}

impl Regions {
    /// Finds the regions of a scene.
    #[must_use]
    pub(super) fn of(scene: &Scene) -> Self {
        let mut found = Self { kinds: vec![outside(scene)], ..Self::default() };
        let mut clear: Vec<usize> =
            (0..scene.objects.len()).filter(|&i| scene.objects[i].interior().is_some()).collect();
        let priority = |i: usize| scene.objects[i].interior().map_or(0, |interior| interior.priority);
        clear.sort_by(|&a, &b| {
            priority(b).cmp(&priority(a)).then(size(&scene.objects[a]).total_cmp(&size(&scene.objects[b])))
        });
        found.touching = Touching::of(scene, &clear);
        for object in clear {
            found.add(scene, object);
        }
        let mirrors = (0..scene.objects.len()).filter(|&i| is_closed_mirror(scene, &scene.objects[i]));
        found.regions.extend(mirrors.map(|object| Region { object, kind: None, place: 0, radius: 0.0 }));
        found
    }

    fn add(&mut self, scene: &Scene, index: usize) {
        let object = &scene.objects[index];
        let Some(interior) = object.interior() else { return };
        let medium = &interior.medium;
        let motion = motion(scene, &**medium);
        let radius = leap_radius(motion, &**medium, object).filter(|_| scene.rays.leaps && is_alone(scene, index));
        let parts = medium.facts().parts;
        let leaps = radius.is_some();
        let same =
            |kind: &RegionKind| kind.motion == motion && kind.leaps == leaps && kind.index.as_ref() == Some(&parts);
        let kind = self.kinds.iter().position(same).unwrap_or_else(|| {
            self.kinds.push(RegionKind { motion, leaps, index: Some(parts), media: Vec::new() });
            self.kinds.len() - 1
        });
        let media = &mut self.kinds[kind].media;
        let place = media.iter().position(|known| **known == **medium).unwrap_or_else(|| {
            media.push(Arc::clone(medium));
            media.len() - 1
        });
        let inside = |center| object.shape.ball_inside(&object.transform, center).max(0.0);
        let radius = radius.or(medium.facts().capture.map(|capture| inside(capture.anchor.position))).unwrap_or(0.0);
        self.regions.push(Region { object: index, kind: Some(kind), place, radius });
        let meets = motion.closed_form().is_some_and(|form| form.meets_obstacles) && !leaps;
        if let Some(center) = medium.facts().center.filter(|_| meets) {
            let met = in_the_way(scene, index, center);
            self.obstacles.extend(met.into_iter().map(|(center, radius)| Obstacle { place, center, radius }));
            if self.obstacles.is_empty() {
                // No list of the shaders may be empty: this sphere never intersects a ray.
                self.obstacles.push(Obstacle { place, center, radius: 0.0 });
            }
        }
    }

    /// Returns the bit of an object, if it has one.
    #[must_use]
    pub fn bit(&self, object: usize) -> Option<usize> {
        self.regions.iter().position(|region| region.object == object)
    }
}

fn is_closed_mirror(scene: &Scene, object: &Object) -> bool {
    scene.continues_from(object) && object.shape.refuses_interior().is_none()
}

/// Returns the kind of the space outside all objects.
fn outside(scene: &Scene) -> RegionKind {
    let straight = Motion::Closed(&STRAIGHT);
    if scene.law.facts().is_straight && scene.scatters() {
        let vacuum: Arc<dyn Medium> = Arc::new(medium::VACUUM);
        return RegionKind { motion: straight, leaps: false, index: Some(vacuum.facts().parts), media: vec![vacuum] };
    }
    if let Some(form) = scene.law.facts().closed_form.filter(|_| scene.rays.method.kind.path == Path::Closed) {
        return RegionKind { motion: Motion::Closed(form), leaps: false, index: None, media: Vec::new() };
    }
    let Some(medium) = scene.law.facts().medium() else {
        return RegionKind { motion: Motion::Law, leaps: false, index: None, media: Vec::new() };
    };
    let motion = match motion(scene, &**medium) {
        Motion::Closed(form) if form.meets_obstacles => Motion::Law,
        Motion::Solved => Motion::Law,
        closed => closed,
    };
    RegionKind { motion, leaps: false, index: Some(medium.facts().parts), media: vec![Arc::clone(medium)] }
}

/// Returns the cheapest motion that is correct for a medium.
fn motion(scene: &Scene, medium: &dyn Medium) -> Motion {
    let closed = medium.facts().closed_form(scene.rays.max_parameter.is_some());
    let allowed = closed.filter(|_| scene.rays.closed_forms || !medium.facts().bends());
    allowed.map_or(Motion::Solved, Motion::Closed)
}

/// Returns the radius of the sphere that a path leaves in closed form: the object itself, if it is a sphere around the medium's center.
fn leap_radius(motion: Motion, medium: &dyn Medium, object: &Object) -> Option<f64> {
    motion.closed_form().filter(|form| form.leaps)?;
    let radius = object.shape.ball_radius(&object.transform)?;
    let center = medium.facts().center?;
    (center.distance(object.transform.0.translation) <= 1e-12 * radius).then_some(radius)
}

/// Returns `true` if no other surface is inside the sphere `object`.
fn is_alone(scene: &Scene, object: usize) -> bool {
    in_the_way(scene, object, scene.objects[object].transform.0.translation).is_empty()
}

/// Returns bounding spheres around the parts of other objects inside `object`, as seen from the middle of its medium.
fn in_the_way(scene: &Scene, object: usize, middle: DVec3) -> Vec<(DVec3, f64)> {
    let (center, radius) = scene.objects[object].ball();
    let met = |other: &Object| {
        let (place, reach) = other.ball();
        let apart = center.distance(place) >= radius + reach;
        if apart || other.shape.holds_ball(&other.transform, center, radius) {
            return None;
        }
        other.shape.ball_in_ball(&other.transform, middle, center, radius)
    };
    scene.objects.iter().enumerate().filter(|(i, _)| *i != object).filter_map(|(_, other)| met(other)).collect()
}

fn size(object: &Object) -> f64 {
    object.ball().1
}
