//! Vertex colors: over a triangle they are mixed by barycentric coordinates. So colors that are an affine function of the position at the
//! vertices are that function everywhere.

use std::fmt::Write as _;

use bentray::gpu::Geometry;
use bentray::program::{Analysis, Program, ProgramOptions, Schedule};
use bentray::render::{RenderSettings, Renderer};
use bentray::scene::Scene;
use glam::{DMat3, DVec3};

use crate::support::gpu;

/// Returns linear colors in a cube of half width 1, from 0.05 to 0.95.
fn color(p: DVec3) -> DVec3 {
    let gradient = DMat3::from_cols_array(&[0.2, -0.1, 0.05, 0.05, 0.25, -0.1, 0.2, -0.1, 0.3]);
    DVec3::splat(0.5) + gradient * p
}

/// The transfer function of IEC 61966-2-1.
fn encoded(x: f64) -> f64 {
    if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 }
}

/// Returns a cube, each side cut into n × n squares and wound inward, so that its mirror image is treated as a solid.
fn cube(n: u32) -> String {
    let mut obj = String::new();
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                for (a, b) in [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)] {
                    let at = |k: u32| 2.0 * f64::from(k) / f64::from(n) - 1.0;
                    let mut p = [0.0; 3];
                    (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (side, at(a), at(b));
                    let c = color(p.into()).to_array().map(encoded);
                    writeln!(obj, "v {} {} {} {} {} {}", p[0], p[1], p[2], c[0], c[1], c[2]).unwrap();
                }
                obj += if side > 0.0 { "f -1 -2 -3 -4\n" } else { "f -4 -3 -2 -1\n" };
            }
        }
    }
    obj
}

/// An image of parallel rays along z, of this square around the origin.
const SIZE: u32 = 24;
const HALF: f64 = 2.0;

/// Returns a scene of cubes that are only rotated around z, in front of a white sky.
fn scene(n: u32, rays: &str, materials: &str, objects: &[String]) -> Scene {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("cube.obj"), cube(n)).unwrap();
    let objects = objects.join(" }, { shape = \"mesh\", file = \"cube.obj\", ");
    // In path tracing only emitters give light.
    let is_traced = rays.contains("path-tracing");
    let lights = if is_traced { "" } else { "lights = [{ kind = \"directional\", direction = [0, 0, -1] }]\n" };
    let text = format!(
        "image = {{ size = [{SIZE}, {SIZE}] }}\ncamera = {{ kind = \"orthographic\", height = {}, position = [0, 0, 20] }}\n\
         sky = {{ color = [1, 1, 1] }}\nrays = {{ bounding_sphere = {{ radius = 40 }}, {rays} }}\n\
         objects = [{{ shape = \"mesh\", file = \"cube.obj\", {objects} }}]\n\
         {lights}{materials}\n",
        2.0 * HALF
    );
    Scene::parse(&text, &folder.path().join("scene.toml"), &[]).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// Compares each pixel with `expected`, a function of its object, counted from 0, and the position in object space.
fn check(scene: &Scene, schedule: Schedule, tolerance: f64, expected: impl Fn(usize, DVec3) -> DVec3) {
    let options = ProgramOptions { schedule, ..ProgramOptions::default() };
    let settings = RenderSettings { options, ..RenderSettings::default() };
    let band = Renderer::new(&gpu(), scene, settings).unwrap().render().unwrap().band;
    let mut seen = 0;
    for (i, (row, column)) in (0..SIZE).flat_map(|row| (0..SIZE).map(move |column| (row, column))).enumerate() {
        let at = |k: u32| HALF * (2.0 * (f64::from(k) + 0.5) / f64::from(SIZE) - 1.0);
        let (x, y) = (at(column), -at(row));
        let front = scene.objects.iter().enumerate().filter_map(|(object, own)| {
            let map = own.transform.0;
            let front = map.transform_point3(DVec3::Z).z;
            let p = map.inverse().transform_point3(DVec3::new(x, y, front));
            (p.truncate().abs().max_element() < 0.999).then_some((front, object, p))
        });
        let Some((_, object, p)) = front.max_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
        seen += 1;
        let found = [0, 1, 2].map(|k| f64::from(band.color[k][i]));
        let expected = expected(object, p);
        assert!(
            DVec3::from(found).abs_diff_eq(expected, tolerance),
            "pixel {column}, {row}: {found:?} and not {expected:?}: {scene:?}"
        );
    }
    assert!(seen > SIZE * SIZE / 2, "only {seen} pixels show an object");
}

const PLACE: &str = "scale = [2.5, 1.8, 0.6], rotate = [0, 0, 25], translate = [0.2, -0.3, 0.1], material = \"m\"";
const EMISSIVE: &str = "materials.m = { kind = \"emissive\", color = { vertex_colors = true } }";

/// Half a unit in the last place of 32 bits, relative.
const U: f64 = 1.0 / 16_777_216.0;
/// A color is a sum of three products of rounded numbers, which is the only error in 64 bits, because colors remain in 32.
const DOUBLE: f64 = 6.0 * U;
/// In 32 bits a position 20 from the camera has four roundings of that, and the color changes by at most √(0.1² + 0.25²)
/// per unit of the cube, which is at least 1.8 in the scene.
const SINGLE: f64 = 4.0 * 20.0 * U * 0.27 / 1.8 + DOUBLE;

#[test]
fn vertex_colors_are_mixed_by_barycentric_coordinates() {
    for accelerate in ["bvh", "grid", "none"] {
        for (precision, tolerance) in [("f32", SINGLE), ("f64", DOUBLE)] {
            let rays = format!("acceleration = \"{accelerate}\", precision = \"{precision}\"");
            check(&scene(2, &rays, EMISSIVE, &[PLACE.to_owned()]), Schedule::Whole, tolerance, |_, p| color(p));
        }
    }
    for schedule in [Schedule::Paper, Schedule::Segment, Schedule::Fused] {
        check(&scene(1, "", EMISSIVE, &[PLACE.to_owned()]), schedule, SINGLE, |_, p| color(p));
    }
}

/// Checks combinations of ray settings, a material, and the factor of the vertex colors.
#[test]
fn vertex_colors_multiply_the_color_of_any_material() {
    let half = DVec3::new(0.5, 1.0, 0.25);
    let cases: [(&str, &str, DVec3); 6] = [
        ("", "{ diffuse = { vertex_colors = true }, ambient = 0.25 }", DVec3::splat(1.25)),
        ("", "{ diffuse = { color = [0.5, 1, 0.25], vertex_colors = true }, ambient = 0 }", half),
        // A mesh without texture coordinates is at (0, 0) everywhere.
        (
            "",
            "{ kind = \"emissive\", color = { checker = [[0.75, 0.75, 0.75], [0, 0, 0]], vertex_colors = true } }",
            DVec3::splat(0.75),
        ),
        ("", "{ kind = \"mirror\", color = { color = [0.5, 1, 0.25], vertex_colors = true } }", half),
        ("lighting = \"path-tracing\"", "{ diffuse = { vertex_colors = true } }", DVec3::ONE),
        (
            "lighting = \"path-tracing\"",
            "{ kind = \"emissive\", color = { color = [0.5, 1, 0.25], vertex_colors = true } }",
            half,
        ),
    ];
    for (rays, material, factor) in cases {
        let scene = scene(1, rays, &format!("materials.m = {material}"), &[PLACE.to_owned()]);
        check(&scene, Schedule::Whole, 2.0 * SINGLE, |_, p| color(p) * factor);
    }
}

/// Checks instances of a mesh, with a material that uses its colors and one that does not.
#[test]
fn meshes_that_are_kept_once_have_their_colors_in_every_place() {
    let materials = "[materials]\nm = { kind = \"emissive\", color = { vertex_colors = true } }\n\
                     plain = { kind = \"emissive\", color = { checker = [[0.25, 0.5, 0.75], [0, 0, 0]] } }";
    let place = |i: u32| {
        let (turn, at) = (17 * i, [0.9 * f64::from(i % 4) - 1.4, 0.9 * f64::from(i / 4) - 1.4, 0.3 * f64::from(i)]);
        let material = if i.is_multiple_of(3) { "plain" } else { "m" };
        format!("scale = [0.7, 0.5, 0.1], rotate = [0, 0, {turn}], translate = {at:?}, material = \"{material}\"")
    };
    let scene = scene(40, "acceleration = \"bvh\"", materials, &(0..16).map(place).collect::<Vec<_>>());
    assert!(Analysis::of(&scene).structure.once);
    // The smallest scale across the view is 0.5 instead of 1.8.
    check(&scene, Schedule::Whole, 1.8 / 0.5 * SINGLE, |object, p| {
        if object.is_multiple_of(3) { DVec3::new(0.25, 0.5, 0.75) } else { color(p) }
    });
}

/// A program only supports vertex colors if a material uses them.
#[test]
fn scenes_that_do_not_use_vertex_colors_do_not_pay_for_them() {
    let linked = |material: &str| {
        let scene = scene(1, "", &format!("materials.m = {{ diffuse = {material} }}"), &[PLACE.to_owned()]);
        let geometry = Geometry::new(&scene);
        let program = Program::new(&scene, &geometry.analysis, &ProgramOptions::default(), geometry.extent()).unwrap();
        program.passes.iter().map(|(_, linked, _)| linked.source.contains("note_corners")).collect::<Vec<bool>>()
    };
    assert_eq!(linked("[1, 1, 1]"), [false]);
    assert_eq!(linked("{ vertex_colors = true }"), [true]);
}
