//! Rays without a file: fans from a point, and parallel bundles.

use glam::{DQuat, DVec3};

use super::pairs::Pairs;
use crate::error::Error;
use crate::scene::CutPlane;

/// The maximum number of rays of one option.
const MOST: usize = 100_000;
/// The tolerance for a ray in a plane: for the sine of its angle to the plane, and for the height of its start as a fraction of the extent.
const OFF: f64 = 1e-9;

/// The rays of one option, next to each other in a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Beam {
    shape: Shape,
    /// The start of a fan, or the middle of a bundle.
    from: DVec3,
    /// The unit direction of the middle ray.
    along: DVec3,
    count: usize,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    /// The angle between the outermost rays, in degrees.
    Fan(f64),
    /// The distance between the outermost rays.
    Bundle(f64),
}

impl Beam {
    pub fn fan(text: &str) -> Result<Self, String> {
        let example = "from=[-5,0,0] toward=[0,0,0] spread=30 count=9";
        let pairs = Pairs::read(text, &["from", "toward", "spread", "count"], example)?;
        Self::read(&pairs, || pairs.positive("spread", 360.0).map(Shape::Fan))
    }

    pub fn bundle(text: &str) -> Result<Self, String> {
        let example = "from=[-5,0,0] toward=[0,0,0] width=2 count=9";
        let pairs = Pairs::read(text, &["from", "toward", "width", "count"], example)?;
        Self::read(&pairs, || pairs.positive("width", 1e30).map(Shape::Bundle))
    }

    fn read(pairs: &Pairs, shape: impl Fn() -> Result<Shape, String>) -> Result<Self, String> {
        let (from, toward) = (pairs.vector("from")?, pairs.vector("toward")?);
        let along = (toward - from).try_normalize();
        let along = along.ok_or("`from` and `toward` are the same point, so there is no direction")?;
        Ok(Self { shape: shape()?, from, along, count: pairs.count("count", MOST)? })
    }

    /// Returns the start of the rays, or the middle of their starts.
    pub fn from(&self) -> DVec3 {
        self.from
    }

    /// Returns the name of the beam in messages.
    pub fn name(&self) -> String {
        let [x, y, z] = self.from.to_array();
        let kind = if matches!(self.shape, Shape::Fan(_)) { "fan" } else { "bundle" };
        format!("the {kind} from [{x}, {y}, {z}]")
    }

    fn lies_in(&self, plane: &CutPlane) -> bool {
        let extent = 1.0 + self.from.length().max(plane.point.length());
        self.along.dot(plane.normal()).abs() <= OFF && plane.height(self.from).abs() <= OFF * extent
    }

    /// Returns the plane of the beam if none is requested: the closest to x and y, else to x and z, else to y and z.
    fn own_plane(&self) -> Option<CutPlane> {
        let axes = [DVec3::Z, DVec3::Y, DVec3::X];
        let steep = |axis: DVec3| self.along.dot(axis).abs();
        let least =
            axes.into_iter().fold(DVec3::Z, |least, axis| if steep(axis) < steep(least) { axis } else { least });
        CutPlane::new(self.from, least.reject_from_normalized(self.along))
    }

    /// Returns the rays in a plane that contains the beam, each as a position and a unit velocity.
    fn rays(&self, plane: &CutPlane) -> Vec<[f64; 6]> {
        let normal = plane.normal();
        let ray = |i: usize| {
            // From −1/2 to 1/2; in a full circle, the last ray would coincide with the first.
            let gaps = if self.shape == Shape::Fan(360.0) { self.count } else { self.count - 1 };
            let part = if gaps == 0 { 0.0 } else { i as f64 / gaps as f64 - 0.5 };
            let (x, v) = match self.shape {
                Shape::Fan(spread) => {
                    let turn = DQuat::from_axis_angle(normal, (part * spread).to_radians());
                    (self.from, turn * self.along)
                }
                Shape::Bundle(width) => (self.from + part * width * normal.cross(self.along), self.along),
            };
            [x.x, x.y, x.z, v.x, v.y, v.z]
        };
        (0..self.count).map(ray).collect()
    }
}

/// Returns the rays of every beam: in `plane` if it is given, else in one plane of two axes if all beams allow it, else each beam in
/// its own plane.
pub(super) fn rays(beams: &[Beam], plane: Option<&CutPlane>) -> Result<Vec<Vec<[f64; 6]>>, Error> {
    if let Some(plane) = plane {
        if let Some(beam) = beams.iter().find(|beam| !beam.lies_in(plane)) {
            let problem = "is outside the plane of --cut; move `from` and `toward` into the plane, or remove --cut";
            return Err(usage!("{} {problem}", beam.name()));
        }
        return Ok(beams.iter().map(|beam| beam.rays(plane)).collect());
    }
    let planes =
        [DVec3::Z, DVec3::Y, DVec3::X].into_iter().filter_map(|normal| CutPlane::new(beams.first()?.from, normal));
    let common = planes.into_iter().find(|plane| beams.iter().all(|beam| beam.lies_in(plane)));
    let rays = |beam: &Beam| common.or_else(|| beam.own_plane()).map(|plane| beam.rays(&plane)).unwrap_or_default();
    Ok(beams.iter().map(rays).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fan_spreads_evenly_in_its_plane() {
        let fan = Beam::fan("from = [1, 0, 2], toward=[1,5,2], spread=60, count=3").unwrap();
        let [rays] = &rays(&[fan], None).unwrap()[..] else { panic!() };
        assert_eq!(rays.len(), 3);
        let sine = 0.5;
        for (ray, x) in rays.iter().zip([sine, 0.0, -sine]) {
            let expected = [1.0, 0.0, 2.0, x, (1.0_f64 - x * x).sqrt(), 0.0];
            let off = ray.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-15, "{ray:?}");
        }
        let round = Beam::fan("from=[0,0,0] toward=[1,0,0] spread=360 count=4").unwrap();
        let directions: Vec<_> = rays_of(&round).iter().map(|ray| [ray[3].round(), ray[4].round()]).collect();
        assert_eq!(directions, [[-1.0, 0.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0]]);
    }

    fn rays_of(beam: &Beam) -> Vec<[f64; 6]> {
        rays(&[*beam], None).unwrap().remove(0)
    }

    #[test]
    fn a_bundle_is_as_wide_as_it_says() {
        let bundle = Beam::bundle("from=[0,0,5],toward=[0,0,0],width=3,count=4").unwrap();
        let rays = rays_of(&bundle);
        let places: Vec<f64> = rays.iter().map(|ray| ray[0]).collect();
        assert!(places.windows(2).all(|p| (p[1] - p[0]).abs() - 1.0 < 1e-15), "{places:?}");
        assert!(rays.iter().all(|ray| ray[1..] == [0.0, 5.0, 0.0, 0.0, -1.0]));
        assert_eq!(rays_of(&Beam { count: 1, ..bundle }), [[0.0, 0.0, 5.0, 0.0, 0.0, -1.0]]);
    }

    #[test]
    fn beams_share_a_plane_if_they_can() {
        let beams = ["from=[0,0,5] toward=[0,0,0] width=3 count=2", "from=[0,5,0] toward=[0,0,1] width=3 count=2"]
            .map(|text| Beam::bundle(text).unwrap());
        let all = rays(&beams, None).unwrap().concat();
        assert!(all.iter().all(|ray| ray[0].abs() < 1e-15 && ray[3].abs() < 1e-15), "{all:?}");
        let plane = CutPlane::new(DVec3::ZERO, DVec3::Y).unwrap();
        let error = rays(&beams, Some(&plane)).unwrap_err().to_string();
        assert!(error.contains("the bundle from [0, 5, 0] is outside the plane of --cut"), "{error}");
    }

    #[test]
    fn what_is_wrong_is_said() {
        for (text, problem) in [
            ("", "missing `from`; for example `from="),
            ("from=[0,0,0]", "missing `toward`; for example `from="),
            ("from=[0,0] toward=[1,0,0]", "`from`: expected three numbers such as [1, 0, -2.5], found `[0,0]`"),
            (
                "from=[0,0,0 toward=[1,0,0]",
                "`from`: expected three numbers such as [1, 0, -2.5], found `[0,0,0 toward=[1,0,0]`",
            ),
            ("from=[0,0,0", "missing `]` in `from=[0,0,0`"),
            ("from=[0,0,0] toward=[0,0,0] spread=3 count=2", "the same point"),
            (
                "from=[0,0,0] toward=[1,0,0] spread=400 count=2",
                "`spread`: expected a number > 0 and at most 360, found `400`",
            ),
            (
                "from=[0,0,0] toward=[1,0,0] spread=30 count=0",
                "`count`: expected a whole number from 1 to 100000, found `0`",
            ),
            ("from=[0,0,0] from=[1,0,0]", "`from` is given twice"),
            ("width=3", "unknown key `width`, expected one of from, toward, spread, count"),
            ("30", "expected KEY=VALUE, as in `from="),
        ] {
            let error = Beam::fan(text).unwrap_err();
            assert!(error.contains(problem), "{text}: {error}");
        }
    }
}
