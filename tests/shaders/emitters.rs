//! The bounding boxes of emitters: directions to them, and the density of those directions.

use glam::{DMat3, DVec3, Vec4};

use super::{Random, U, row, wide};
use crate::support::{gpu, probe::Probe};

/// The number of strata along each axis of the unit square.
const STRATA: u32 = 64;

/// A box as an emitter: half its edges, and the way to its center from the position that it is seen from.
struct Case {
    edges: DMat3,
    way: DVec3,
}

impl Case {
    fn rows(&self, u: [f64; 2]) -> [Vec4; 7] {
        let map = self.edges.inverse().transpose();
        let radius = (self.edges * DVec3::ONE).length();
        let volume = 8.0 * self.edges.determinant().abs();
        [
            row(self.way.as_vec3(), u[0] as f32),
            row(self.edges.x_axis.as_vec3(), u[1] as f32),
            row(self.edges.y_axis.as_vec3(), radius as f32),
            row(self.edges.z_axis.as_vec3(), volume as f32),
            row(map.x_axis.as_vec3(), 0.0),
            row(map.y_axis.as_vec3(), 0.0),
            row(map.z_axis.as_vec3(), 0.0),
        ]
    }

    /// Returns the solid angle of the visible faces: two triangles for each (van Oosterom and Strackee 1983).
    fn solid_angle(&self) -> f64 {
        let x = -(self.edges.inverse() * self.way);
        let triangle = |[a, b, c]: [DVec3; 3]| {
            let [l, m, n] = [a, b, c].map(DVec3::length);
            2.0 * a.dot(b.cross(c)).abs().atan2(l * m * n + a.dot(b) * n + b.dot(c) * l + c.dot(a) * m)
        };
        let face = |i: usize| {
            let at = |p: f64, q: f64| {
                let mut corner = DVec3::ZERO;
                corner[i] = x[i].signum();
                corner[(i + 1) % 3] = p;
                corner[(i + 2) % 3] = q;
                self.way + self.edges * corner
            };
            let [a, b, c, d] = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
            if x[i].abs() > 1.0 { triangle([a, b, c]) + triangle([a, c, d]) } else { 0.0 }
        };
        (0..3).map(face).sum()
    }
}

const BODY: &str = "let emitter = Emitter(p0.xyz, p2.w, p1.xyz, 1.0, p2.xyz, p3.w, p3.xyz, p4.xyz, p5.xyz, p6.xyz);
    let view = box_view(emitter, p0.xyz);
    let d = box_way(emitter, view, p0.xyz, vec2f(p0.w, p1.w));
    put(0u, vec4f(d, box_density(emitter, view, d)));
    put(1u, vec4f(view.shares, 0.0));";

fn run(inputs: &[[Vec4; 7]]) -> Vec<[Vec4; 2]> {
    let parts = ["path/light_sampling/emitters", "path/vertex", "surface/scatter/lobe"];
    Probe::new(&parts).with("EMITS_FROM_BOXES").run::<7, 2>(&gpu(), BODY, inputs)
}

/// The mean of 1/density over the samples is the solid angle of the box, if directions have the density that they are said to have.
#[test]
fn directions_to_boxes_have_their_density() {
    let mut random = Random::new(5);
    let cases: Vec<Case> = (0..40)
        .map(|i| {
            let turn = DMat3::from_axis_angle(random.direction(), random.within(0.0, 3.0));
            let flat = if i % 2 == 0 { 1e-3 } else { random.within(0.1, 2.0) };
            let size = DVec3::new(random.within(0.1, 2.0), flat, random.within(0.1, 2.0));
            let edges = turn * DMat3::from_diagonal(size);
            Case { edges, way: random.direction() * random.within(1.2, 20.0) * size.length() }
        })
        .collect();
    let strata = |k: u32| (f64::from(k) + 0.5) / f64::from(STRATA);
    let cells = (0..STRATA * STRATA).map(|cell| [strata(cell % STRATA), strata(cell / STRATA)]);
    let cells: Vec<_> = cells.collect();
    let inputs: Vec<_> = cases.iter().flat_map(|case| cells.iter().map(|u| case.rows(*u))).collect();
    for (case, samples) in cases.iter().zip(run(&inputs).chunks(cells.len())) {
        let mut sum = 0.0;
        let mut missed = 0;
        for [sample, _] in samples {
            let d = wide(*sample);
            assert!((d.length() - 1.0).abs() < 8.0 * U, "{d}");
            if sample.w > 0.0 {
                sum += 1.0 / f64::from(sample.w);
            } else {
                missed += 1;
            }
        }
        // Rounding may move only the outermost of the samples off a face.
        assert!(missed <= STRATA as usize / 16, "{missed} directions miss the box");
        let (mean, exact) = (sum / samples.len() as f64, case.solid_angle());
        // Strata at the border of two faces belong to one of them, each with an error of at most its share.
        assert!((mean / exact - 1.0).abs() < 2.0 / f64::from(STRATA), "{mean} for {exact} at {}", case.way);
    }
}

/// A position in the box sees no face, and one that is too far away samples the sphere.
#[test]
fn boxes_are_sampled_from_outside_and_nearby() {
    let edges = DMat3::from_diagonal(DVec3::new(1.0, 0.5, 0.25));
    let at = |way: DVec3| Case { edges, way }.rows([0.5, 0.5]);
    let out = run(&[at(DVec3::new(0.9, 0.4, -0.2)), at(DVec3::new(0.0, 2e4, 0.0)), at(DVec3::new(0.0, 3.0, 0.0))]);
    assert_eq!(wide(out[0][1]), DVec3::ZERO);
    assert_eq!(wide(out[1][1]), DVec3::ZERO);
    assert_eq!(wide(out[2][1]), DVec3::Y);
}
