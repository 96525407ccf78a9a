//! Where surfaces cross a plane: the outlines of a drawing.
//!
//! *Theory.* An affine map takes planes to planes, so that every shape is cut in its own space, where it is simple, and the
//! outline is mapped back: a sphere's is an ellipse, a box's a polygon with three to six corners.
//!
//! *Practice.* All in 64 bits on the host; a mesh costs a pass over its triangles. Curves come as closed polygons of
//! [`CORNERS`] corners, which are off by 2·10⁻⁴ of their radius.

mod convex;
mod mesh;
mod plane;

pub use plane::CutPlane;

use std::f64::consts::TAU;

use glam::DVec3;

use super::{Falloff, Law, Medium, Object, Shape};

/// Corners of the polygon that stands for an ellipse.
pub const CORNERS: u32 = 180;

/// A line in which a surface crosses a plane, in scene coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Its points, at least two.
    pub points: Vec<DVec3>,
    /// Whether the last point is joined to the first.
    pub closed: bool,
}

/// A plane n · y = d in a shape's own space.
#[derive(Debug, Clone, Copy)]
struct OwnPlane {
    /// n: a unit vector.
    normal: DVec3,
    /// d.
    offset: f64,
}

impl Object {
    /// Where its surface crosses the plane: nothing if it does not. A surface that lies in the plane shows its edge.
    #[must_use]
    pub fn cut(&self, plane: &CutPlane) -> Vec<Outline> {
        let map = self.transform.0;
        let Some(own) = OwnPlane::of(plane, map.matrix3.transpose(), map.translation) else { return Vec::new() };
        let outlines = match &self.shape {
            Shape::Sphere => sphere(own).into_iter().collect(),
            Shape::Box => convex::cuboid(own).into_iter().collect(),
            Shape::Cylinder => convex::cylinder(own).into_iter().collect(),
            Shape::Plane => convex::square(own).into_iter().collect(),
            Shape::Disk { hole } => disk(own, *hole),
            Shape::Mesh(mesh) => mesh::cut(mesh, own),
        };
        let placed = |outline: Outline| Outline {
            points: outline.points.into_iter().map(|p| map.transform_point3(p)).collect(),
            closed: outline.closed,
        };
        outlines.into_iter().map(placed).collect()
    }
}

impl OwnPlane {
    /// The scene's plane n · (x − p) = 0 under x = M y + t: Mᵀn · y = n · (p − t).
    fn of(plane: &CutPlane, transposed: glam::DMat3, translation: DVec3) -> Option<Self> {
        let normal = transposed * plane.normal();
        let length = normal.length();
        let offset = plane.normal().dot(plane.point - translation) / length;
        let own = Self { normal: normal / length, offset };
        (own.normal.is_finite() && offset.is_finite()).then_some(own)
    }
}

/// The unit sphere's circle.
fn sphere(plane: OwnPlane) -> Option<Outline> {
    let radius = (1.0 - plane.offset * plane.offset).sqrt();
    (radius > 0.0).then(|| circle(plane.normal * plane.offset, plane.normal, radius))
}

/// The part of the disk hole² ≤ x² + z² ≤ 1 of y = 0: a line, or two beside the hole; its edges if it lies in the plane.
fn disk(plane: OwnPlane, hole: f64) -> Vec<Outline> {
    let slope = DVec3::new(plane.normal.x, 0.0, plane.normal.z);
    if slope.length() <= convex::PARALLEL {
        let edges = [1.0, hole].into_iter().filter(|radius| *radius > 0.0 && plane.offset.abs() <= convex::ON);
        return edges.map(|radius| circle(DVec3::ZERO, DVec3::Y, radius)).collect();
    }
    let foot = slope * (plane.offset / slope.length_squared());
    let along = slope.cross(DVec3::Y).normalize();
    let half = |radius: f64| (radius * radius - foot.length_squared()).max(0.0).sqrt();
    let (outer, inner) = (half(1.0), half(hole));
    let stretches = if inner > 0.0 { vec![[-outer, -inner], [inner, outer]] } else { vec![[-outer, outer]] };
    let line = |ends: [f64; 2]| Outline { points: ends.map(|t| foot + t * along).to_vec(), closed: false };
    stretches.into_iter().filter(|[from, to]| from < to).map(line).collect()
}

fn circle(center: DVec3, normal: DVec3, radius: f64) -> Outline {
    let (a, b) = normal.any_orthonormal_pair();
    let corner = |i: u32| {
        let (sin, cos) = (TAU * f64::from(i) / f64::from(CORNERS)).sin_cos();
        center + radius * (cos * a + sin * b)
    };
    Outline { points: (0..CORNERS).map(corner).collect(), closed: true }
}

/// A sphere that a law has without an object: what it is, and its outline in a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Landmark {
    /// Its name in a legend.
    pub name: &'static str,
    /// Where it crosses the plane.
    pub outline: Outline,
}

impl Law {
    /// Horizons, spheres that capture, and the edges of media, where they cross the plane.
    #[must_use]
    pub fn cut(&self, plane: &CutPlane) -> Vec<Landmark> {
        let spheres = match self {
            Self::Schwarzschild { mass, center, .. } => vec![("horizon", *center, 2.0 * mass)],
            Self::Sources(sources) => sources
                .iter()
                .flat_map(|source| {
                    let reach = match source.falloff {
                        Falloff::Cubic { radius } => radius,
                        Falloff::InverseSquare | Falloff::Yukawa { .. } => 0.0,
                    };
                    [("capture", source.position, source.capture), ("reach of a source", source.position, reach)]
                })
                .collect(),
            Self::Medium(
                Medium::Luneburg { center, radius, .. }
                | Medium::Gaussian { center, radius, .. }
                | Medium::Eaton { center, radius },
            ) => vec![("r = R", *center, *radius)],
            Self::Medium(Medium::Explosion(explosion)) => vec![("r = R", explosion.center, explosion.radius)],
            Self::Straight | Self::Flow { .. } | Self::Medium(_) => Vec::new(),
        };
        let landmark = |(name, center, radius): (&'static str, DVec3, f64)| {
            let height = plane.height(center);
            let within = (radius * radius - height * height).sqrt();
            let middle = center - height * plane.normal();
            (within > 0.0).then(|| Landmark { name, outline: circle(middle, plane.normal(), within) })
        };
        spheres.into_iter().filter_map(landmark).collect()
    }
}
