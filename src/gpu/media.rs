//! The values of media, by the names of their members in WGSL.

use super::records::Value::{self, Float, Uint, Uint4, Vec3};
use super::source::Source;
use crate::program::{Purpose, Region};
use crate::scene::{Ingoing, Medium, ProfilePoint, Shape};

impl Source<'_> {
    /// The rows of `regions`.
    pub(super) fn regions(&self) -> Vec<[(&'static str, Value); 5]> {
        let regions = &self.geometry.regions;
        let row = |region: &Region| {
            [
                ("kind", Uint(region.kind.unwrap_or(0) as u32)),
                ("place", Uint(region.place as u32)),
                ("primitive", Uint(self.geometry.primitive(region.object))),
                ("start", Uint(u32::from(self.starts_in(region.object)))),
                ("radius", Float(region.radius)),
            ]
        };
        regions.regions.iter().map(row).collect()
    }

    /// Do the camera's rays start inside of this mesh? Where an analytic shape is concerned every ray finds out for itself.
    fn starts_in(&self, object: usize) -> bool {
        let object = &self.scene.objects[object];
        let camera = self.scene.camera.as_ref().filter(|_| self.program.choice.purpose != Purpose::Trace);
        matches!(object.shape, Shape::Mesh(_)) && camera.is_some_and(|camera| object.contains(camera.position))
    }

    fn kind(&self, kind: usize) -> &[Medium] {
        self.geometry.regions.kinds.get(kind).map_or(&[], |kind| &kind.media)
    }

    /// Of the media of a kind.
    pub(super) fn media(&self, kind: usize) -> Vec<Vec<(&'static str, Value)>> {
        let mut first = 0;
        let mut row = |medium: &Medium| {
            let values = medium_values(medium, first);
            first += (profile_values(medium).len() + samples(medium).len()) as u32;
            values
        };
        self.kind(kind).iter().map(&mut row).collect()
    }

    /// Of the profiles in them.
    pub(super) fn profiles(&self, kind: usize) -> Vec<[(&'static str, Value); 5]> {
        self.kind(kind).iter().flat_map(profile_values).collect()
    }

    /// Of the grids in them.
    pub(super) fn index_samples(&self, kind: usize) -> Vec<f32> {
        self.kind(kind).iter().flat_map(|medium| samples(medium).iter().copied()).collect()
    }
}

/// The points of a medium's profile, if it is one.
#[must_use]
pub fn profile_values(medium: &Medium) -> Vec<[(&'static str, Value); 5]> {
    let Medium::Profile { profile, .. } = medium else { return Vec::new() };
    let row = |point: &ProfilePoint| {
        [
            ("height", Float(point.height)),
            ("n", Float(point.n)),
            ("slope", Float(point.slope)),
            ("bend", Float(point.bend)),
            ("twist", Float(point.twist)),
        ]
    };
    profile.points.iter().map(row).collect()
}

/// The samples of a medium, if it is a grid.
fn samples(medium: &Medium) -> &[f32] {
    match medium {
        Medium::Grid(grid) => &grid.samples,
        _ => &[],
    }
}

/// The members of `Medium` in the medium's part. The points of a profile or the samples of a grid begin at `first` in the list of
/// all.
#[must_use]
pub fn medium_values(medium: &Medium, first: u32) -> Vec<(&'static str, Value)> {
    match medium {
        Medium::Constant { n } => vec![("n", Float(*n))],
        Medium::Luneburg { center, radius, c } => {
            vec![("center", Vec3(*center)), ("radius", Float(*radius)), ("c", Float(*c))]
        }
        Medium::Gaussian { center, radius, a, b } => {
            vec![("center", Vec3(*center)), ("radius", Float(*radius)), ("a", Float(*a)), ("b", Float(*b))]
        }
        Medium::InverseR { center, k, ingoing } => vec![
            ("center", Vec3(*center)),
            ("k", Float(*k)),
            ("capture", Float(capture_radius(*k))),
            ("continued", Uint(u32::from(*ingoing == Ingoing::Continued))),
        ],
        Medium::Fisheye { center, n0, a } => {
            vec![("center", Vec3(*center)), ("n0", Float(*n0)), ("a", Float(*a))]
        }
        Medium::Eaton { center, radius } => vec![("center", Vec3(*center)), ("radius", Float(*radius))],
        Medium::Rod { center, axis, n0, g } => {
            vec![("center", Vec3(*center)), ("axis", Vec3(*axis)), ("n0", Float(*n0)), ("g", Float(*g))]
        }
        Medium::Linear { origin, n0, gradient } => {
            vec![("origin", Vec3(*origin)), ("n0", Float(*n0)), ("gradient", Vec3(*gradient))]
        }
        Medium::Exponential { origin, up, delta, height } => {
            vec![("origin", Vec3(*origin)), ("up", Vec3(*up)), ("delta", Float(*delta)), ("height", Float(*height))]
        }
        Medium::Sech { origin, up, n0, g } => {
            vec![("origin", Vec3(*origin)), ("up", Vec3(*up)), ("n0", Float(*n0)), ("g", Float(*g))]
        }
        Medium::Profile { origin, up, profile } => vec![
            ("origin", Vec3(*origin)),
            ("up", Vec3(*up)),
            ("first", Uint(first)),
            ("points", Uint(profile.points.len() as u32)),
        ],
        Medium::Noise(n) | Medium::Textured(n) => vec![
            ("center", Vec3(n.center)),
            ("n0", Float(n.n0)),
            ("amplitude", Float(n.amplitude)),
            ("frequency", Float(n.frequency)),
            ("octaves", Uint(n.octaves)),
            ("seed", Uint(n.seed)),
        ],
        Medium::Explosion(n) => vec![
            ("center", Vec3(n.center)),
            ("radius", Float(n.radius)),
            ("amplitude", Float(n.amplitude)),
            ("frequency", Float(n.frequency)),
            ("octaves", Uint(n.octaves)),
            ("seed", Uint(n.seed)),
        ],
        Medium::Expression { center, scale, .. } => vec![("center", Vec3(*center)), ("scale", Float(*scale))],
        Medium::Grid(grid) => vec![
            ("origin", Vec3(grid.origin)),
            ("cell", Vec3(grid.cell)),
            ("size", Uint4([grid.size[0], grid.size[1], grid.size[2], first])),
        ],
    }
}

/// Rays that come this near to the middle of n = k/r never come back: there n is 10⁴.
#[must_use]
pub fn capture_radius(k: f64) -> f64 {
    1e-4 * k
}
