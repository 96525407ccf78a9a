//! Regions: the space outside of everything, and the inside of each object that light goes through.
//!
//! *Theory.* Each *kind* of region has a motion of its own, at the cheapest tier that is right for its medium, and its own
//! copy of the parts that follow rays; regions of one kind differ by numbers only. Where several objects overlap, the one of
//! the highest priority is there, and of equal ones the smaller; so the objects are numbered in that order, a ray carries the
//! set of those that it is in as bits, and the lowest bit is the medium around it. Closed mirrors have bits too, behind all
//! others: not for their medium, but to know from which side a ray meets them.

use std::sync::Arc;

use glam::DVec3;

use super::touching::Touching;
use crate::model::method::Path;
use crate::model::{ClosedForm, Medium, STRAIGHT, Wgsl, medium};
use crate::scene::{Object, Scene};

/// How rays move in a region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// By the scene's own law and method.
    Law,
    /// In closed form.
    Closed(&'static ClosedForm),
    /// By the scene's method, in the medium's index.
    Solved,
}

impl Motion {
    /// The closed form, if it is one.
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
    /// How its rays move.
    pub motion: Motion,
    /// Does one step lead through the whole region, because nothing else is in it?
    pub leaps: bool,
    /// The parts that know its index; none for laws that have none.
    pub index: Option<Vec<Wgsl>>,
    /// Of the regions of this kind, in the order of their places.
    pub media: Vec<Arc<dyn Medium>>,
}

impl RegionKind {
    /// Are its segments straight, or not tested at all?
    #[must_use]
    pub fn is_line(&self) -> bool {
        self.leaps || self.motion.closed_form().is_some_and(|form| form.is_line)
    }
}

/// An object with a side that rays can be on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Region {
    /// Index into the scene's objects.
    pub object: usize,
    /// Index into the kinds; none for mirrors, which have no medium.
    pub kind: Option<usize>,
    /// Which medium of that kind.
    pub place: usize,
    /// The largest sphere about the medium's centre that is inside of the object: a leap ends on it.
    pub radius: f64,
}

/// A ball around what a spiral may meet in an inverse-r medium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Obstacle {
    /// Which medium of its kind it is in.
    pub place: usize,
    /// The ball's.
    pub center: DVec3,
    /// The ball's.
    pub radius: f64,
}

/// All regions of a scene.
#[derive(Debug, Clone, Default)]
pub struct Regions {
    /// The first is that of the space outside.
    pub kinds: Vec<RegionKind>,
    /// By bit.
    pub regions: Vec<Region>,
    /// What lies in the way of spirals.
    pub obstacles: Vec<Obstacle>,
    /// Whose surfaces lie on others.
    pub touching: Touching,
}

impl Regions {
    /// Of a scene.
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
                // No list of the shaders may be empty: a ball that nothing meets.
                self.obstacles.push(Obstacle { place, center, radius: 0.0 });
            }
        }
    }

    /// The bit of an object, if it has one.
    #[must_use]
    pub fn bit(&self, object: usize) -> Option<usize> {
        self.regions.iter().position(|region| region.object == object)
    }
}

fn is_closed_mirror(scene: &Scene, object: &Object) -> bool {
    scene.continues_from(object) && object.shape.refuses_interior().is_none()
}

/// The space outside of all objects.
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

/// The cheapest motion that is right for a medium.
fn motion(scene: &Scene, medium: &dyn Medium) -> Motion {
    let closed = medium.facts().closed_form(scene.rays.length.is_some());
    let allowed = closed.filter(|_| scene.rays.closed_forms || !medium.facts().bends());
    allowed.map_or(Motion::Solved, Motion::Closed)
}

/// The sphere that a path leaves in closed form: the object's own, where it is a sphere about the medium's centre.
fn leap_radius(motion: Motion, medium: &dyn Medium, object: &Object) -> Option<f64> {
    motion.closed_form().filter(|form| form.leaps)?;
    let radius = object.shape.ball_radius(&object.transform)?;
    let center = medium.facts().center?;
    (center.distance(object.transform.0.translation) <= 1e-12 * radius).then_some(radius)
}

/// Is no other surface in the sphere `object`?
fn is_alone(scene: &Scene, object: usize) -> bool {
    in_the_way(scene, object, scene.objects[object].transform.0.translation).is_empty()
}

/// Balls around what other objects have inside of `object`, seen from the middle of its medium.
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
