//! Regions: the space outside of everything, and the inside of each object that light goes through.
//!
//! *Theory.* Each *kind* of region has a motion of its own, at the cheapest tier that is right for its medium, and its own
//! copy of the parts that follow rays; regions of one kind differ by numbers only. Where several objects overlap, the one of
//! the highest priority is there, and of equal ones the smaller; so the objects are numbered in that order, a ray carries the
//! set of those that it is in as bits, and the lowest bit is the medium around it. Closed mirrors have bits too, behind all
//! others: not for their medium, but to know from which side a ray meets them.

use super::touching::Touching;
use crate::scene::{Law, MaterialKind, Medium, Method, Object, Scene, Shape, Substance, Transform};
use glam::DVec3;

/// How rays move in a region.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// By the scene's own law and method.
    Law,
    /// Straight on.
    Straight,
    /// As on a spring: Luneburg's lens and the gradient rod.
    Harmonic,
    /// Along logarithmic spirals.
    Spiral,
    /// In circles: Maxwell's fisheye.
    Circle,
    /// Along parabolas.
    Parabola,
    /// By the scene's method, in the medium's index.
    Solved,
}

/// A kind of region.
#[derive(Debug, Clone, PartialEq)]
pub struct Kind {
    /// How its rays move.
    pub motion: Motion,
    /// Does one step lead through the whole region, because nothing else is in it?
    pub leaps: bool,
    /// The parts that know its index; none for laws that have none.
    pub index: Option<&'static [&'static str]>,
    /// Of the regions of this kind, in the order of their places.
    pub media: Vec<Medium>,
}

impl Kind {
    /// Are its segments straight, or not tested at all?
    #[must_use]
    pub fn is_line(&self) -> bool {
        self.motion == Motion::Straight || self.leaps
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
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Regions {
    /// The first is that of the space outside.
    pub kinds: Vec<Kind>,
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
    pub fn of(scene: &Scene) -> Self {
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

    fn add(&mut self, scene: &Scene, object: usize) {
        let Some(interior) = scene.objects[object].interior() else { return };
        let medium = &interior.medium;
        let motion = motion(scene, medium);
        let radius =
            leap_radius(motion, medium, &scene.objects[object]).filter(|_| scene.rays.leaps && is_alone(scene, object));
        let index = Some(index_parts(medium));
        let leaps = radius.is_some();
        let same = |kind: &Kind| (kind.motion, kind.leaps, kind.index) == (motion, leaps, index);
        let kind = self.kinds.iter().position(same).unwrap_or_else(|| {
            self.kinds.push(Kind { motion, leaps, index, media: Vec::new() });
            self.kinds.len() - 1
        });
        let media = &mut self.kinds[kind].media;
        let place = media.iter().position(|known| known == medium).unwrap_or_else(|| {
            media.push(medium.clone());
            media.len() - 1
        });
        let radius = radius.unwrap_or_else(|| inscribed(&scene.objects[object], medium));
        self.regions.push(Region { object, kind: Some(kind), place, radius });
        if let (Motion::Spiral, Medium::InverseR { center, .. }, false) = (motion, medium, leaps) {
            let met = in_the_way(scene, object, *center);
            self.obstacles.extend(met.into_iter().map(|(center, radius)| Obstacle { place, center, radius }));
            if self.obstacles.is_empty() {
                // No list of the shaders may be empty: a ball that nothing meets.
                self.obstacles.push(Obstacle { place, center: *center, radius: 0.0 });
            }
        }
    }

    /// Is there a kind of region whose rays are followed by the scene's method?
    #[must_use]
    pub fn need_method(&self) -> bool {
        self.kinds.iter().any(|kind| matches!(kind.motion, Motion::Law | Motion::Solved))
    }

    /// The bit of an object, if it has one.
    #[must_use]
    pub fn bit(&self, object: usize) -> Option<usize> {
        self.regions.iter().position(|region| region.object == object)
    }
}

/// Does a ray go on from some surface of the scene?
#[must_use]
pub fn scatters(scene: &Scene) -> bool {
    scene.objects.iter().any(|object| object.interior().is_some() || is_mirror(scene, object))
}

/// Is there a surface that both reflects and transmits?
#[must_use]
pub fn splits(scene: &Scene) -> bool {
    scene.objects.iter().any(|object| object.interior().is_some())
}

/// Is its surface a mirror?
#[must_use]
pub fn is_mirror(scene: &Scene, object: &Object) -> bool {
    matches!(object.substance, Substance::Opaque(material) if scene.materials[material].kind == MaterialKind::Mirror)
}

fn is_closed_mirror(scene: &Scene, object: &Object) -> bool {
    is_mirror(scene, object) && object.shape.is_closed()
}

/// The space outside of all objects.
fn outside(scene: &Scene) -> Kind {
    match &scene.law {
        Law::Straight if scatters(scene) => {
            let vacuum = Medium::Constant { n: 1.0 };
            Kind { motion: Motion::Straight, leaps: false, index: Some(index_parts(&vacuum)), media: vec![vacuum] }
        }
        Law::Straight if scene.rays.method == Method::Exact => {
            Kind { motion: Motion::Straight, leaps: false, index: None, media: Vec::new() }
        }
        Law::Medium(medium) => Kind {
            motion: match motion(scene, medium) {
                Motion::Solved => Motion::Law,
                closed => closed,
            },
            leaps: false,
            index: Some(index_parts(medium)),
            media: vec![medium.clone()],
        },
        _ => Kind { motion: Motion::Law, leaps: false, index: None, media: Vec::new() },
    }
}

/// The cheapest motion that is right for a medium.
fn motion(scene: &Scene, medium: &Medium) -> Motion {
    let closed = match medium {
        Medium::Constant { .. } | Medium::Textured(_) => return Motion::Straight,
        Medium::Luneburg { .. } | Medium::Rod { .. } => Motion::Harmonic,
        Medium::InverseR { .. } => Motion::Spiral,
        Medium::Fisheye { .. } => Motion::Circle,
        _ => Motion::Parabola,
    };
    let allowed = scene.rays.closed_forms && medium.has_closed_form(scene.rays.length.is_some());
    if allowed { closed } else { Motion::Solved }
}

/// The parts that know a medium's index.
fn index_parts(medium: &Medium) -> &'static [&'static str] {
    match medium {
        Medium::Constant { .. } => &["medium/constant"],
        Medium::Luneburg { .. } => &["medium/luneburg"],
        Medium::Gaussian { .. } => &["medium/gaussian"],
        Medium::InverseR { .. } => &["medium/inverse_r"],
        Medium::Fisheye { .. } => &["medium/fisheye"],
        Medium::Eaton { .. } => &["medium/eaton"],
        Medium::Rod { .. } => &["medium/rod"],
        Medium::Linear { .. } => &["medium/linear"],
        Medium::Exponential { .. } => &["medium/exponential"],
        Medium::Sech { .. } => &["medium/sech"],
        Medium::Profile { .. } => &["medium/profile"],
        Medium::Noise(_) => &["medium/noise", "medium/fractal_noise"],
        Medium::Textured(_) => &["medium/textured", "medium/fractal_noise"],
        Medium::Explosion(_) => &["medium/explosion", "medium/fractal_noise"],
        Medium::Expression { .. } => &["medium/expression", "medium/formula", "medium/finite"],
        Medium::Grid(_) => &["medium/grid", "medium/finite"],
    }
}

/// The sphere that a path leaves in closed form: the object's own, where it is a sphere about the medium's centre.
fn leap_radius(motion: Motion, medium: &Medium, object: &Object) -> Option<f64> {
    let radius = object.transform.uniform_scale().filter(|_| matches!(object.shape, Shape::Sphere))?;
    let center = match (motion, medium) {
        (
            Motion::Harmonic | Motion::Spiral | Motion::Circle,
            Medium::Luneburg { center, .. } | Medium::InverseR { center, .. } | Medium::Fisheye { center, .. },
        ) => *center,
        _ => return None,
    };
    (center.distance(object.transform.0.translation) <= 1e-12 * radius).then_some(radius)
}

/// Is no other surface in the sphere `object`?
fn is_alone(scene: &Scene, object: usize) -> bool {
    in_the_way(scene, object, scene.objects[object].transform.0.translation).is_empty()
}

/// Balls around what other objects have inside of `object`, seen from the middle of its medium.
fn in_the_way(scene: &Scene, object: usize, middle: DVec3) -> Vec<(DVec3, f64)> {
    let (center, radius) = ball(&scene.objects[object]);
    let met = |other: &Object| {
        let (place, reach) = ball(other);
        let apart = center.distance(place) >= radius + reach;
        let around = matches!(other.shape, Shape::Sphere)
            && other.transform.uniform_scale().is_some_and(|outer| center.distance(place) + radius <= outer);
        if apart || around {
            return None;
        }
        match other.shape {
            Shape::Plane => part_of_plane(other, middle, center, radius),
            _ => Some((place, reach)),
        }
    };
    scene.objects.iter().enumerate().filter(|(i, _)| *i != object).filter_map(|(_, other)| met(other)).collect()
}

/// A ball around the part of a plane that is in another ball, about the foot of the perpendicular from `middle`; none if there is no
/// such part.
fn part_of_plane(plane: &Object, middle: DVec3, center: DVec3, radius: f64) -> Option<(DVec3, f64)> {
    let Transform(map) = plane.transform;
    let normal = map.matrix3.x_axis.cross(map.matrix3.z_axis).normalize_or_zero();
    let height = |x: DVec3| (x - map.translation).dot(normal);
    let part = (radius * radius - height(center).powi(2)).max(0.0).sqrt();
    let [foot, place] = [middle, center].map(|x| x - height(x) * normal);
    (height(center).abs() < radius).then_some((foot, part + foot.distance(place)))
}

/// The largest ball about the middle of a medium that is inside of its object, or 0 where that is not known.
fn inscribed(object: &Object, medium: &Medium) -> f64 {
    let Medium::InverseR { center, .. } = medium else { return 0.0 };
    let map = object.transform.0;
    let radius = match object.shape {
        Shape::Sphere => {
            object.transform.uniform_scale().map_or(0.0, |radius| radius - center.distance(map.translation))
        }
        Shape::Box => {
            let own = map.inverse().transform_point3(*center);
            let [x, y, z] = map.inverse().matrix3.transpose().to_cols_array_2d().map(|row| DVec3::from(row).length());
            ((DVec3::ONE - own.abs()) / DVec3::new(x, y, z)).min_element()
        }
        _ => 0.0,
    };
    radius.max(0.0)
}

/// A ball that holds all of the object.
fn ball(object: &Object) -> (DVec3, f64) {
    let map = object.transform.0;
    let own = match &object.shape {
        Shape::Sphere | Shape::Disk { .. } => 1.0,
        Shape::Plane | Shape::Cylinder => 2.0_f64.sqrt(),
        Shape::Box => 3.0_f64.sqrt(),
        Shape::Mesh(mesh) => mesh.vertices.iter().map(|v| v.position.as_dvec3().length()).fold(0.0, f64::max),
    };
    let m = map.matrix3;
    let stretch = [m.x_axis, m.y_axis, m.z_axis].into_iter().map(DVec3::length).fold(0.0, f64::max);
    (map.translation, own * stretch)
}

fn size(object: &Object) -> f64 {
    ball(object).1
}
