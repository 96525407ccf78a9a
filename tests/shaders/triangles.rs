//! Triangles: no gaps between neighbors, and correct hits.

use bentray::model::Value::{Uint, Uint4, Vec3 as V3};
use bentray::program::constant;
use glam::{DVec3, Vec3, Vec4};

use super::{Errors, Random, U, Verdict, awkward_directions, check_hits, row, vectors, wide};
use crate::support::{
    gpu,
    probe::{Probe, Record},
};

const PARTS: [&str; 10] = [
    "segment/ray",
    "state/loops",
    "segment/walk",
    "segment/pieces",
    "segment/structure/boxes",
    "segment/structure/bvh",
    "segment/order",
    "segment/curve_line",
    "shape/placed",
    "surface/vertex_colors",
];

/// Returns a probe with a hierarchy of triangles alone.
pub(super) fn probe() -> Probe {
    Probe::new(&PARTS).with("HAS_VERTEX_COLORS").with("ITEMS_IN_ORDER").stub(bentray::program::part("shape/triangle").expect("a part").text).stub(
        "const ITEM_KIND: u32 = TRIANGLE;
        fn item_fraction(item: u32, a: vec3f, d: vec3f) -> f32 { return triangle_fraction(item & PRIMITIVE_INDEX, a, d); }",
    )
}

fn corners(t: [Vec3; 3]) -> Record {
    let [p, q, r] = t.map(|x| V3(x.as_dvec3()));
    vec![("p", p), ("bit", Uint(constant("shape/facing", "NO_BIT") as u32)), ("q", q), ("r", r)]
}

/// Returns a box as the CPU writes it.
pub(super) fn grown(lo: Vec3, hi: Vec3) -> [Vec3; 2] {
    let slack = constant("segment/structure/boxes", "BOX_SLACK") * lo.abs().max(hi.abs()).as_dvec3();
    [lo.as_dvec3() - slack, hi.as_dvec3() + slack].map(DVec3::as_vec3)
}

#[test]
fn an_edge_has_two_opposite_sides() {
    let mut random = Random::new(101);
    let directions = vectors(&mut random, 3000, 1e-6, 1e6);
    let mut inputs: Vec<[Vec4; 3]> = directions
        .iter()
        .map(|d| {
            let p = random.vector(1e-6, 1e6);
            // Some edges are along the axes, so that their ends share coordinates.
            let q = if random.unit() < 0.5 {
                p + random.vector(1e-6, 10.0)
            } else {
                Vec3::new(p.x, random.unit() as f32, p.z)
            };
            [row(*d, 0.0), row(p, 0.0), row(q, 0.0)]
        })
        .collect();
    for d in awkward_directions() {
        inputs.push([row(d, 0.0), row(Vec3::new(0.0, 1.0, -0.0), 0.0), row(Vec3::new(-0.0, 1.0, 2.0), 0.0)]);
        inputs.push([row(d, 0.0), row(d, 0.0), row(d, 0.0)]);
    }
    let body = "put(0u, vec4f(edge_side(p0.xyz, p1.xyz, p2.xyz), edge_side(p0.xyz, p2.xyz, p1.xyz), 0.0, 0.0));";
    let mut errors = Errors::of("edge_side");
    for (input, [sides]) in inputs.iter().zip(&probe().run::<3, 1>(&gpu(), body, &inputs)) {
        let opposite = sides.x.to_bits() == (-sides.y).to_bits() || (sides.x == 0.0 && sides.y == 0.0);
        // If both ends are equal there is no edge: without rounding of products p × p need not be 0.
        assert!(opposite || input[1] == input[2], "{:e} and {:e} at {input:?}", sides.x, sides.y);
        let [d, p, q] = input.map(wide);
        // Each component of the cross product has two roundings, and the sum has three.
        errors.check(sides.x, d.dot(p.cross(q)), 9.0 * U * d.length() * p.length() * q.length(), input);
    }
    errors.report();
}

/// Two triangles that share an edge, seen along a ray through it: at least one is hit, whatever the rounding.
#[test]
fn no_ray_passes_between_neighbours() {
    let mut random = Random::new(102);
    let (mut triangles, mut inputs) = (Vec::new(), Vec::new());
    for k in 0..6000_u32 {
        let d = if k % 5 == 0 { awkward_directions()[k as usize % 60].as_dvec3() } else { random.direction() };
        let shift = random.vector(0.01, 100.0).as_dvec3();
        let p = shift + random.vector(0.1, 3.0).as_dvec3();
        let q = shift + random.vector(0.1, 3.0).as_dvec3();
        // The third corners are on either side of the edge as the ray sees it, at any depth.
        let across = (q - p).cross(d);
        let mid = 0.5 * (p + q);
        let r = mid + across * random.within(0.2, 1.0) + d * random.within(-1.0, 1.0);
        let s = mid - across * random.within(0.2, 1.0) + d * random.within(-1.0, 1.0);
        let on_edge = p + (q - p) * random.within(0.2, 0.8);
        let far = random.log(0.5, 50.0);
        let (a, b) = (on_edge - d * far, on_edge + d * far * random.within(0.5, 2.0));
        triangles.extend([[p, q, r], [q, p, s]].map(|t| corners(t.map(DVec3::as_vec3))));
        inputs.push([row(a.as_vec3(), 2.0 * k as f32), row(b.as_vec3(), 0.0)]);
    }
    let body = "let d = p1.xyz - p0.xyz;
        put(0u, vec4f(triangle_fraction(u32(p0.w), p0.xyz, d), triangle_fraction(u32(p0.w) + 1u, p0.xyz, d), 0.0, 0.0));";
    let probe = probe().bind("corners", triangles);
    let (mut both, mut each) = (0, [0, 0]);
    for (input, [t]) in inputs.iter().zip(&probe.run::<2, 1>(&gpu(), body, &inputs)) {
        assert!(t.x < 1.5 || t.y < 1.5, "a ray slips between two triangles: {input:?}");
        both += u32::from(t.x < 1.5 && t.y < 1.5);
        each[usize::from(t.x > 1.5)] += 1;
    }
    println!("through shared edges: {each:?} hit the first or only the second, {both} both, of {}", inputs.len());
    assert!(each[0] > 1500 && each[1] > 1500, "the rays do not fall on both sides");
}

/// A mesh of separate triangles and its hierarchy: a root and leaves of four.
struct Mesh(Vec<[Vec3; 3]>);

impl Mesh {
    fn new(random: &mut Random) -> Self {
        Self(
            (0..32)
                .map(|_| {
                    let center = random.vector(0.5, 6.0);
                    [0; 3].map(|_| center + random.vector(0.3, 2.0))
                })
                .collect(),
        )
    }

    fn probe(&self) -> Probe {
        let node = |of: &[[Vec3; 3]], skip: u32, leaf: u32| -> Record {
            let all: Vec<Vec3> = of.iter().flatten().copied().collect();
            let lo = all.iter().copied().reduce(Vec3::min).expect("corners");
            let [lo, hi] = grown(lo, all.iter().copied().reduce(Vec3::max).expect("corners"));
            let bits = |corner: Vec3, last| {
                let [x, y, z] = corner.to_array().map(f32::to_bits);
                Uint4([x, y, z, last])
            };
            vec![("lo_skip", bits(lo, skip)), ("hi_leaf", bits(hi, leaf))]
        };
        let leaves = self.0.chunks(4).enumerate();
        let mut nodes = vec![node(&self.0, 1 + self.0.len() as u32 / 4, 0)];
        nodes.extend(leaves.map(|(k, four)| node(four, k as u32 + 2, (4 << 28) | (4 * k as u32))));
        probe()
            .bind("nodes", nodes)
            .bind("corners", self.0.iter().map(|t| corners(*t)).collect::<Vec<Record>>())
            .numbers("mesh", &self.words())
    }

    /// Returns the mesh. Triangle k belongs to object k mod 3, with material 7 and so on; a vertex has its position as its color.
    fn words(&self) -> Vec<u32> {
        let [triangle, vertex] = [("shape/triangle", "TRIANGLE_WORDS"), ("surface/vertex_colors", "COLOR_WORD")]
            .map(|(part, name)| constant(part, name) as u32);
        let vertex = vertex + 3;
        let first = triangle * self.0.len() as u32;
        let corners = (0..self.0.len() as u32).flat_map(|k| {
            let [a, b, c] = [3 * k, 3 * k + 1, 3 * k + 2].map(|corner| first + vertex * corner);
            [a, b, c, k % 3, 7 + k % 3]
        });
        let vertices = self.0.iter().flatten().flat_map(|x| {
            let normal = x.normalize_or(Vec3::Y);
            [normal.x, normal.y, normal.z, x.x, x.y, x.x, x.y, x.z].map(f32::to_bits)
        });
        corners.chain(vertices).collect()
    }
}

/// Returns the fraction at which the piece hits the triangle, with its edges moved outward by `moved` and its plane by `lift`,
/// in units of rounding errors: the volume of an edge errs by 9 U |d| |p| |q|, the height of the plane by 8 U of |edges| |p|.
fn fraction(t: &[Vec3; 3], a: DVec3, d: DVec3, moved: f64, eta: f64) -> Option<f64> {
    let [p, q, r] = t.map(|x| x.as_dvec3() - a);
    let side = |p: DVec3, q: DVec3| (d.dot(p.cross(q)), moved * 9.0 * U * d.length() * p.length() * q.length());
    let sides = [side(p, q), side(q, r), side(r, p)];
    let inside = sides.iter().all(|(s, e)| s + e >= 0.0) || sides.iter().all(|(s, e)| s - e <= 0.0);
    let n = (q - p).cross(r - p);
    let at = n.dot(p) / n.dot(d);
    (inside && at >= -1e-5 - eta && at <= 1.0 + 1e-5 + eta).then_some(at)
}

#[test]
fn meshes_by_hierarchy_and_by_brute_force() {
    let mut random = Random::new(103);
    let mesh = Mesh::new(&mut random);
    let mut inputs = Vec::new();
    for _ in 0..6000 {
        let aim = random.vector(0.1, 12.0);
        let away = random.vector(1.0, 60.0);
        inputs.push([row(aim + away, 0.0), row(aim - away * random.within(-0.5, 1.5) as f32, 0.0)]);
    }
    for d in awkward_directions() {
        let at = random.vector(0.1, 5.0);
        inputs.push([row(at - d * 10.0, 0.0), row(at + d * 10.0, 0.0)]);
    }
    let body = "let d = p1.xyz - p0.xyz;
        let hit = structure_hit(Segment(p0.xyz, d, p1.xyz, d, 1.0), 1u, Hit(2.0, NOTHING));
        let missed = hit.primitive == NOTHING;
        put(0u, vec4f(hit.t, select(f32(hit.primitive & PRIMITIVE_INDEX), -1.0, missed), 0.0, 0.0));
        let surface = surface_triangle(select(hit.primitive & PRIMITIVE_INDEX, 0u, missed), p0.xyz + hit.t * (p1.xyz - p0.xyz));
        put(1u, vec4f(surface.normal, surface.signed_distance));
        put(2u, vec4f(surface.shading_normal, 0.0));
        put(3u, vec4f(surface.uv, f32(surface.material), f32(surface.object)));
        put(4u, vec4f(vertex_color(), 0.0));";
    let out = mesh.probe().run::<2, 5>(&gpu(), body, &inputs);
    let names =
        ["triangle's gap", "triangle's plane", "triangle's uv", "triangle's shading normal", "triangle's vertex color"];
    let [mut gaps, mut planes, mut uvs, mut normals, mut colors] = names.map(Errors::of);
    let cases: Vec<_> = inputs
        .iter()
        .zip(&out)
        .map(|(input, output)| {
            let (a, b) = (wide(input[0]), wide(input[1]));
            let d = b - a;
            let mut verdicts = Vec::new();
            let mut slack = 0.0_f64;
            for t in &mesh.0 {
                let [p, q, r] = t.map(Vec3::as_dvec3);
                let n = (q - p).cross(r - p);
                let error = 16.0 * U * (q - p).length() * (r - p).length() * (a.length() + p.length()) / n.dot(d).abs();
                let each: Vec<_> = [(1.0, error), (1.0, -error), (-1.0, error), (-1.0, -error)]
                    .map(|(m, e)| fraction(t, a, d, m, e))
                    .into();
                let verdict = Verdict::of(&each);
                slack = slack.max(if verdict == Verdict::Miss { 0.0 } else { error });
                verdicts.push(verdict);
            }
            if output[0].y >= 0.0 {
                let t = mesh.0[output[0].y as usize].map(Vec3::as_dvec3);
                let x = a + f64::from(output[0].x) * d;
                let n = (t[1] - t[0]).cross(t[2] - t[0]);
                let thin = (t[1] - t[0]).length() * (t[2] - t[0]).length() / n.length();
                // The point is rounded, and computed from a distant start; n errs by U times the thinness of the triangle.
                let off =
                    16.0 * U * (a.length() + b.length()) * thin * (1.0 + d.length() * n.length() / n.dot(d).abs());
                gaps.check(output[1].w, 0.0, off, input);
                planes.check3(output[1], n.normalize(), 8.0 * U * thin, input);
                let object = output[0].y as u32 % 3;
                assert_eq!((output[3].z, output[3].w), (7.0 + object as f32, object as f32), "owner");
                // Vertices have u = x and v = y, and so has every point; small distant triangles lose digits.
                uvs.check(output[3].x, x.x, 8.0 * off * thin, input);
                uvs.check(output[3].y, x.y, 8.0 * off * thin, input);
                // Their colors are their positions.
                colors.check3(output[4], x, 8.0 * off * thin, input);
                // Weights by Cramer's rule in the plane; the normal of a vertex is its direction.
                let (e, f, g) = (t[1] - t[0], t[2] - t[0], x - t[0]);
                let (ee, ef, ff) = (e.dot(e), e.dot(f), f.dot(f));
                let v = (ff * e.dot(g) - ef * f.dot(g)) / (ee * ff - ef * ef);
                let w = (ee * f.dot(g) - ef * e.dot(g)) / (ee * ff - ef * ef);
                let sum = (1.0 - v - w) * t[0].normalize() + v * t[1].normalize() + w * t[2].normalize();
                let short = e.length().min(f.length()).min((e - f).length());
                normals.check3(output[2], sum.normalize(), 8.0 * off * thin / short / sum.length() + 8.0 * U, input);
            }
            (output[0].x, nearest(&verdicts), slack, format!("{input:?}"))
        })
        .collect();
    check_hits("meshes", 0.03, cases);
    for errors in [gaps, planes, uvs, normals, colors] {
        errors.report();
    }
}

fn nearest(all: &[Verdict]) -> Verdict {
    let first = all.iter().filter_map(|v| if let Verdict::Hit(lo, hi) = v { Some((*lo, *hi)) } else { None });
    let first = first.reduce(|a, b| (a.0.min(b.0), a.1.min(b.1)));
    if all.contains(&Verdict::Open) {
        Verdict::Open
    } else {
        first.map_or(Verdict::Miss, |(lo, hi)| Verdict::Hit(lo, hi))
    }
}
