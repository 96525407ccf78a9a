//! Tests the intersections of line segments with spheres, ellipsoids, boxes, cylinders, planes and disks, and the inside of these shapes.

use bentray::model::Value::{Float, Uint, Vec3 as V3, Vec4 as V4};
use glam::{DMat3, DQuat, DVec3, DVec4, Vec4};

use super::lines::{ball, cylinder, first, own_pieces, ring, slabs, square};
use super::{Errors, Random, U, Verdict, awkward_directions, check_hits, row, wide};
use crate::support::{
    gpu,
    probe::{Probe, Record},
};

pub const PARTS: [&str; 10] = [
    "segment/ray",
    "state/loops",
    "segment/pieces",
    "shape/placed",
    "shape/sphere",
    "shape/ellipsoid",
    "shape/box",
    "shape/cylinder",
    "shape/plane",
    "shape/disk",
];

/// The inner radius of every disk, in object space and exact in f32.
pub const HOLE: f64 = 0.25;

/// The placement of a shape: the affine map from the scene's space to object space, rounded to f32.
#[derive(Clone, Copy)]
pub struct Place {
    pub linear: DMat3,
    pub offset: DVec3,
    pub center: DVec3,
    pub radius: f64,
}

impl Place {
    pub fn new(random: &mut Random, scale: DVec3) -> Self {
        let turn = DMat3::from_quat(DQuat::from_axis_angle(random.direction(), random.within(0.0, 6.0)));
        let center = random.vector(0.5, 5.0).as_dvec3();
        let rounded = |v: DVec3| v.as_vec3().as_dvec3();
        let map = DMat3::from_diagonal(1.0 / scale) * turn.transpose();
        let linear = DMat3::from_cols(rounded(map.x_axis), rounded(map.y_axis), rounded(map.z_axis));
        Self { linear, offset: rounded(-(linear * center)), center, radius: rounded(scale).x }
    }

    pub fn own(&self, x: DVec3) -> DVec3 {
        self.linear * x + self.offset
    }

    pub fn record(&self, index: u32) -> Record {
        let rows = self.linear.transpose();
        let own = |axis: DVec3, offset: f64| V4(DVec4::from((axis, offset)));
        vec![
            ("center", V3(self.center)),
            ("radius", Float(self.radius)),
            ("row_x", own(rows.x_axis, self.offset.x)),
            ("row_y", own(rows.y_axis, self.offset.y)),
            ("row_z", own(rows.z_axis, self.offset.z)),
            ("material", Uint(10 + index)),
            ("object", Uint(20 + index)),
        ]
    }

    /// Returns the data that a segment is tested with: a ball, or only the map.
    pub fn tested(&self, kind: &str) -> Record {
        let wanted: &[&str] = if kind == "sphere" { &["center", "radius"] } else { &["row_x", "row_y", "row_z"] };
        let mut record: Record = self.record(0).into_iter().filter(|(name, _)| wanted.contains(name)).collect();
        record.extend((kind == "disk").then_some(("hole", Float(HOLE))));
        record
    }

    /// Returns a bound on the error of the shader's object-space coordinates of a point on the piece: four roundings of terms as large as
    /// |row| |x| for the start, the direction and their sum, and as many in the intersection.
    fn moved(&self, a: DVec3, b: DVec3) -> f64 {
        let size = self.linear.x_axis.abs() + self.linear.y_axis.abs() + self.linear.z_axis.abs();
        12.0 * U * (size.max_element() * (a.length() + b.length()) + self.offset.length() + 1.0)
    }
}

pub fn places(seed: u64) -> [Place; 2] {
    let mut random = Random::new(seed);
    [DVec3::new(1.0, 0.5, 2.0), DVec3::new(0.25, 3.0, 1.5)].map(|scale| Place::new(&mut random, scale))
}

pub fn balls(seed: u64) -> [Place; 2] {
    let mut random = Random::new(seed);
    [1.0, 0.375].map(|radius| Place::new(&mut random, DVec3::splat(radius)))
}

/// Returns a small shape and a large one.
fn extremes(seed: u64) -> [Place; 2] {
    let mut random = Random::new(seed);
    [DVec3::new(0.03, 0.02, 0.04), DVec3::new(300.0, 100.0, 200.0)].map(|scale| Place::new(&mut random, scale))
}

/// Returns short and long pieces, near and far, from outside, inside and along the axes, most of them aimed at a shape.
fn pieces(seed: u64, targets: [Place; 2]) -> Vec<[Vec4; 2]> {
    let mut random = Random::new(seed);
    let mut all = Vec::new();
    for k in 0..4000 {
        let target = targets[k % 2];
        let own = DVec3::from_array([0; 3].map(|_| random.within(-1.6, 1.6)));
        let aim = target.linear.inverse() * (own - target.offset);
        let size = if (0.1..10.0).contains(&target.radius) { 1.0 } else { target.radius };
        let away = random.direction() * (size * random.log(0.1, 200.0));
        let a = aim + away;
        let b = aim - away * random.within(-0.5, 1.5);
        all.push([row(a.as_vec3(), 0.0), row(b.as_vec3(), 0.0)]);
    }
    for d in awkward_directions() {
        for target in targets {
            let shift = random.vector(0.1, 1.0);
            let a = target.center.as_vec3() + shift;
            all.push([row(a - d * 8.0, 0.0), row(a + d * 8.0, 0.0)]);
        }
    }
    for target in targets {
        all.extend(
            own_pieces()
                .into_iter()
                .map(|ends| ends.map(|own| row((target.linear.inverse() * (own - target.offset)).as_vec3(), 0.0))),
        );
    }
    all
}

/// Returns the intervals of the line inside a closed shape whose size in object space is increased by `grown`.
fn intervals(kind: &str, place: &Place, a: DVec3, b: DVec3, grown: f64) -> Vec<Option<[f64; 2]>> {
    let (p, d) = (place.own(a), place.linear * (b - a));
    match kind {
        "sphere" => vec![ball(a - place.center, b - a, place.radius + grown * place.radius)],
        "ellipsoid" => vec![ball(p, d, 1.0 + grown)],
        "box" => vec![slabs(&[0, 1, 2], p, d, 1.0 + grown)],
        "cylinder" => [grown, -grown].map(|taller| cylinder(p, d, 1.0 + grown, 1.0 + taller)).to_vec(),
        _ => Vec::new(),
    }
}

/// Returns all results for a shape under errors of either sign in its size and in t.
fn results(kind: &str, place: &Place, a: DVec3, b: DVec3) -> Vec<Option<f64>> {
    let moved = place.moved(a, b);
    let (p, d) = (place.own(a), place.linear * (b - a));
    let mut all = Vec::new();
    for grown in [moved, -moved] {
        for eta in [4.0 * U, -4.0 * U] {
            let eta = match kind {
                "sphere" => eta * (2.0 + 2.0 * a.distance(place.center) / a.distance(b)),
                "ellipsoid" | "cylinder" => eta * (2.0 + 2.0 * p.length() / d.length()),
                _ => eta,
            };
            match kind {
                "plane" => all.extend([moved, -moved].map(|lift| square(p, d, lift, grown, eta))),
                "disk" => all.extend([moved, -moved].map(|lift| ring(p, d, lift, grown, eta))),
                _ => {
                    let inside = intervals(kind, place, a, b, grown).into_iter();
                    all.extend(inside.map(|inside| inside.and_then(|ends| first(ends, eta))));
                }
            }
        }
    }
    all
}

fn probe(kind: &str, targets: &[Place]) -> Probe {
    let records: Vec<Record> = targets.iter().map(|place| place.tested(kind)).collect();
    let code = kind.to_uppercase();
    let list = match kind {
        "sphere" => "sphere_list",
        "ellipsoid" => "ellipsoid_list",
        "box" => "box_list",
        "cylinder" => "cylinder_list",
        "plane" => "plane_list",
        _ => "disk_list",
    };
    let first = format!(
        "fn first_of_list(a: vec3f, b: vec3f, best: Hit) -> Hit {{
            var hit = best;
            for (var i = 0u; i < {code}_COUNT; i++) {{
                hit = nearer_hit(hit, hit_{kind}({list}[i], {code} | i, a, b - a), {code} | i);
            }}
            return hit;
        }}"
    );
    Probe::new(&PARTS).stub(&first).list(list, &format!("{code}_COUNT"), records)
}

#[test]
fn analytic_shapes() {
    let gpu = gpu();
    for (kind, targets) in [
        ("sphere", balls(81)),
        ("ellipsoid", places(82)),
        ("box", places(83)),
        ("plane", places(84)),
        ("cylinder", places(86)),
        ("disk", places(87)),
        ("cylinder", extremes(88)),
        ("disk", extremes(89)),
    ] {
        let inputs = pieces(85, targets);
        let inside = match kind {
            "plane" | "disk" => "Interval(0.0, 0.0)".to_owned(),
            "sphere" => {
                "sphere_interval(sphere_list[1].center, sphere_list[1].radius, p0.xyz, p1.xyz - p0.xyz)".to_owned()
            }
            "ellipsoid" => "ellipsoid_interval(ellipsoid_list[1], p0.xyz, p1.xyz - p0.xyz)".to_owned(),
            _ => {
                let space = format!("{kind}_list[1]");
                format!("{kind}_interval(local_point({space}, p0.xyz), local_vector({space}, p1.xyz - p0.xyz))")
            }
        };
        let body = format!(
            "let inside = {inside};
            put(1u, vec4f(inside.enters, inside.leaves, 0.0, 0.0));
            let hit = first_of_list(p0.xyz, p1.xyz, Hit(2.0, NOTHING));
            let other = first_of_list(p0.xyz, p1.xyz, Hit(0.3, 5u));
            put(0u, vec4f(hit.t, select(f32(hit.primitive & PRIMITIVE_INDEX), -1.0, hit.primitive == NOTHING), other.t,
                select(f32(other.primitive & PRIMITIVE_INDEX), -1.0, other.primitive == 5u)));"
        );
        let out = probe(kind, &targets).run::<2, 2>(&gpu, &body, &inputs);
        let cases: Vec<_> = inputs
            .iter()
            .zip(&out)
            .map(|(input, [hit, _])| {
                let (a, b) = (wide(input[0]), wide(input[1]));
                let each = targets.map(|place| Verdict::of(&results(kind, &place, a, b)));
                let verdict = nearest(each);
                if let (Verdict::Hit(..), [Verdict::Miss, Verdict::Hit(..)] | [Verdict::Hit(..), Verdict::Miss]) =
                    (verdict, each)
                {
                    assert_eq!(hit.y, f32::from(u8::from(each[0] == Verdict::Miss)), "{kind}: which one");
                }
                // A nearer hit is kept.
                let kept = if hit.x < 0.3 { [hit.x, hit.y] } else { [0.3, -1.0] };
                assert_eq!([hit.z, hit.w], kept, "{kind}: the nearest hit, at {input:?}");
                let far = (a.length() + b.length() + 8.0) / (b - a).length();
                (hit.x, verdict, 8.0 * U * (1.0 + far), format!("{input:?}"))
            })
            .collect();
        check_hits(kind, 0.02, cases);
        if !["plane", "disk"].contains(&kind) {
            check_intervals(kind, &targets[1], inputs.iter().zip(&out).map(|(input, out)| (input, out[1])));
        }
        standing_still(&gpu, &probe(kind, &targets[..1]), kind, &targets[0]);
    }
}

/// Checks both ends if they are on the piece or near it, and that lines that pass by have none.
fn check_intervals<'a>(kind: &'static str, place: &Place, cases: impl Iterator<Item = (&'a [Vec4; 2], Vec4)>) {
    let (mut ends, mut missed) = (Errors::of("interval"), 0);
    for (input, got) in cases {
        let (a, b) = (wide(input[0]), wide(input[1]));
        // The ends may be up to twice the length of the piece away, where errors of the direction count twice.
        let moved = 3.0 * place.moved(a, b);
        let all: Vec<_> = [moved, -moved].iter().flat_map(|grown| intervals(kind, place, a, b, *grown)).collect();
        if all.iter().all(Option::is_none) {
            missed += 1;
            assert!(got.x > got.y, "{kind}: [{}, {}] at {input:?}, which passes by", got.x, got.y);
        }
        if all.iter().any(Option::is_none) {
            continue;
        }
        for k in 0..2 {
            let found = all.iter().flatten().map(|ends| ends[k]);
            let (lo, hi) = (found.clone().fold(f64::INFINITY, f64::min), found.fold(f64::NEG_INFINITY, f64::max));
            if lo > -1.0 && hi < 2.0 && hi - lo < 0.02 {
                let far = (a.length() + b.length() + 8.0) / (b - a).length();
                ends.check(got[k], 0.5 * (lo + hi), 0.5 * (hi - lo) + 8.0 * U * (1.0 + far), input);
            }
        }
    }
    ends.report();
    assert!(missed > 500, "{kind}: only {missed} pass by");
}

fn nearest(each: [Verdict; 2]) -> Verdict {
    match each {
        [Verdict::Open, _] | [_, Verdict::Open] => Verdict::Open,
        [Verdict::Miss, other] | [other, Verdict::Miss] => other,
        [Verdict::Hit(a, b), Verdict::Hit(c, d)] => Verdict::Hit(a.min(c), b.min(d)),
    }
}

/// Checks that a piece of zero length hits nothing.
fn standing_still(gpu: &bentray::gpu::Gpu, probe: &Probe, kind: &str, target: &Place) {
    let inputs = [[row(target.center.as_vec3(), 0.0)], [Vec4::new(50.0, 1.0, -20.0, 0.0)]];
    let body = "let hit = first_of_list(p0.xyz, p0.xyz, Hit(2.0, NOTHING)); put(0u, vec4f(hit.t));";
    for [hit] in probe.run::<1, 1>(gpu, body, &inputs) {
        assert_eq!(hit.x, 2.0, "{kind}: a piece without length");
    }
}
