//! Tests furnaces: between walls of equal emission every pixel is as bright as the walls, under every law that loses no light
//! and with every medium: Le/(1 − albedo) times n² at the camera divided by n² at the walls. This holds for every path, not
//! only on average.

use bentray::assets::Formula;
use bentray::render::{RenderSettings, Renderer, Status};
use glam::DVec3;

use crate::support::{gpu, scene};

/// The rays, the camera, the walls, n² at the camera divided by n² at the walls, and the law. r² is 0.14 at the cameras
/// `round` and `steep`, and 1.74 at `aside` and `front`; `inside` is 0.03 from the center of the transparent object.
const LAWS: &str = r#"
    closed | round | room  | 1 | { kind = "straight" }
    planar | round | ball  | 1 | { kind = "schwarzschild", mass = 0.2, center = [5, 0, 0] }
    steps  | round | ball  | 1 | { kind = "schwarzschild", mass = 0.2, center = [5, 0, 0], form = "geodesic" }
    planar | round | room  | 1 | { kind = "sources", sources = [{ position = [0, 0.6, 0], strength = -0.2 }] }
    steps  | round | room  | 1 | { kind = "sources", sources = [{ position = [0, 0.6, 0], strength = -0.2, falloff = { cubic = 0.5 } }] }
    planar | round | room  | 1 | { kind = "sources", sources = [{ position = [0, 0.6, 0], strength = -0.3, falloff = { yukawa = 1.5 } }] }
    steps  | round | ball  | 1 | { kind = "sources", sources = [{ kind = "line", direction = [0, 0.3, 1], position = [0, 0.6, 0], strength = -0.2 }] }
    steps  | round | ball  | 1 | { kind = "sources", sources = [{ kind = "line", direction = [1, 0, 1], position = [0.5, -1, -0.5], strength = -0.3, falloff = { yukawa = 2 } }, { position = [0, 0.6, 0], strength = -0.2 }, { position = [-1, 0, 0.5], strength = 0.4, falloff = { cubic = 1.5 } }] }
    steps  | round | ball  | 1 | { kind = "sources", parameter = "length", sources = [{ position = [0, 0.6, 0], strength = -0.2 }, { position = [-1, 0, 0.5], strength = 0.4, falloff = { cubic = 1.5 } }] }
    steps  | round | ball  | 1 | { kind = "lorenz", order = 2, sigma = 0.1, rho = 0.1, beta = 0.1 }
    steps  | round | ball  | 1 | { kind = "rossler", order = 2, alpha = 0.05, beta = 0.02, gamma = 0.1 }
    steps  | round | ball  | 1 | { kind = "wgsl", file = "laws/vortex.wgsl", parameters = { axis = [0, 0, 1], strength = 0.2, width = 1 } }
    steps  | round | ball  | 1 | { kind = "wgsl", file = "laws/lattice.wgsl", parameters = { spacing = 1.3, depth = 0.02, half_turn = 3.141592653589793 } }
    steps  | round | ball  | 1 | { kind = "wgsl", file = "laws/magnetic.wgsl", depends = "velocity", parameters = { axis = [0, 1, 0], strength = 0.3, width = 1 } }
    closed | round | ball  | 1 | { kind = "straight", absorption = { coefficient = 0.3, emission = [0.3, 0.15, 0.09] } }
    steps  | round | ball  | 1 | { kind = "sources", sources = [{ position = [0, 0.6, 0], strength = -0.2 }], absorption = { coefficient = 0.3, emission = [0.3, 0.15, 0.09] } }
"#;

/// Furnaces in media that fill space. Walls are where the index is constant over them.
const SPACES: &str = r#"
    closed | round | ball  | 1 | "water"
    closed | round | ball  | (2.5 - 0.14/4)/1.5 | { kind = "luneburg", c = 2.5, radius = 2 }
    steps  | round | ball  | (2.5 - 0.14/4)/1.5 | { kind = "luneburg", c = 2.5, radius = 2 }
    closed | round | ball  | (2/(1 + 0.14/4))^2 | { kind = "maxwell-fisheye", n0 = 2, a = 2 }
    leaps  | round | ball  | exp(2*0.5*(4 - 0.14)/9) | { kind = "gaussian", a = 1.6, b = 0.5, radius = 3 }
    steps  | round | ball  | 4/sqrt(0.14) - 1 | { kind = "eaton", radius = 2 }
    fine   | aside | shell | 4/1.74 | { kind = "inverse-r", k = 1.5 }
    fine   | steep | pipe  | (1 - 0.25*0.13)/(1 - 0.25*1.44) | { kind = "rod", n0 = 1.6, g = 0.5 }
    closed | steep | sky   | (1.96 - 0.8*0.2)/(1.96 - 0.8*0.5) | { kind = "linear", n0 = 1.4, gradient = [0, -0.8, 0] }
    steps  | steep | sky   | ((1 + 0.4*exp(-0.2/0.7))/(1 + 0.4*exp(-0.5/0.7)))^2 | { kind = "exponential", delta = 0.4, height = 0.7 }
    steps  | steep | sky   | (cosh(0.8)/cosh(0.8*0.7))^2 | { kind = "sech", n0 = 1.5, g = 0.8, origin = [0, -0.5, 0] }
    steps  | steep | sky   | (1.2/1.15)^2 | { kind = "profile", points = [[-1, 1.5], [-0.5, 1.4], [0.2, 1.2], [0.5, 1.15], [1, 1.1]] }
    leaps  | aside | cube  | 1 | { kind = "noise", n0 = 1.5, amplitude = 0.15, frequency = 1.5, octaves = 2 }
    leaps  | aside | ball  | 1 | { kind = "explosion", radius = 1.2, amplitude = 0.3, frequency = 1.5, octaves = 3, center = [0.3, 0, 0] }
    leaps  | round | ball  | ((1.5 + 0.3*cos(sqrt(0.14)))/(1.5 + 0.3*cos(2)))^2 | { kind = "expression", n = "1.5 + 0.3*cos(r)" }
    leaps  | round | ball  | (1.5/1.3)^2 | GRID
    leaps  | aside | ball  | 1 | GRID
"#;

/// Furnaces with transparent objects, which must be invisible.
const INTERIORS: &str = r#"
    closed | front  | box    | 1 | 1.5
    closed | front  | sphere | 1 | "diamond"
    closed | inside | sphere | 1.5^2 | 1.5
    closed | front  | rod    | 1 | 0.7
    closed | front  | sphere | 1 | { kind = "luneburg" }
    closed | inside | sphere | 3 - 0.03/0.64 | { kind = "luneburg", c = 3 }
    leaps  | front  | box    | 1 | { kind = "luneburg", c = 3, radius = 1 }
    leaps  | front  | sphere | 1 | { kind = "gaussian", a = 1.5 }
    closed | front  | sphere | 1 | { kind = "inverse-r", ingoing = "continue" }
    closed | front  | sphere | 1 | { kind = "inverse-r", k = 1.4, ingoing = "continue" }
    closed | front  | sphere | 1 | { kind = "maxwell-fisheye" }
    closed | front  | sphere | 1 | { kind = "maxwell-fisheye", n0 = 1.5, a = 2 }
    steps  | front  | sphere | 1 | { kind = "eaton", radius = 1.1 }
    closed | front  | rod    | 1 | { kind = "rod", n0 = 1.6, g = 0.6 }
    closed | front  | sphere | 1 | { kind = "linear", n0 = 1.4, gradient = [0.3, -0.6, 0.1] }
    steps  | front  | sphere | 1 | { kind = "exponential", delta = 0.4, height = 0.7 }
    steps  | front  | box    | 1 | { kind = "sech", n0 = 1.7, g = 0.8 }
    steps  | front  | rod    | 1 | { kind = "profile", points = [[-1, 1.5], [-0.5, 1.4], [0.2, 1.2], [0.5, 1.15], [1, 1.1]] }
    leaps  | front  | sphere | 1 | { kind = "noise", n0 = 1.4, amplitude = 0.1, frequency = 1.5, octaves = 2 }
    closed | front  | sphere | 1 | { kind = "textured", n = 1.5, amplitude = 0.1, frequency = 2, octaves = 3 }
    leaps  | front  | sphere | 1 | { kind = "explosion", amplitude = 0.3, frequency = 2, octaves = 2 }
    leaps  | front  | rod    | 1 | { kind = "expression", n = "1.3 + 0.2*sin(3*x)*cos(2*y) + 0.1*z" }
    leaps  | front  | sphere | 1 | GRID
    closed | front  | sphere | 1 | { kind = "constant", n = 1.5, absorption = { coefficient = 0.4, emission = [0.9, 0.45, 0.27] } }
"#;

/// Furnaces in which light bends back to the surface that it leaves.
const RETURNS: &str = r#"
    steps  | round | ball   | 1 | { kind = "wgsl", file = "laws/magnetic.wgsl", depends = "velocity", parameters = { axis = [0, 1, 0], strength = 0.9, width = 30 } }
    planar | round | ball   | 1 | { kind = "sources", sources = [{ position = [0, -6, 0], strength = 10 }] }
    steps  | round | room   | 1 | { kind = "sources", sources = [{ position = [0, -6, 0], strength = 10 }] }
    sharp  | round | mirror | 1 | { kind = "sources", sources = [{ position = [0, -6, 0], strength = 6 }] }
    planar | aside | star   | 1 | { kind = "schwarzschild", mass = 0.4 }
    steps  | round | ball   | ((1 + 0.1*0.14)/1.4)^2 | { kind = "medium", index = { kind = "expression", n = "1 + 0.1*r^2" } }
    closed | front | glass  | 1 | { kind = "straight" }
"#;

/// The meanings of the words in the tables.
const WORDS: &str = r#"
    closed | max_segments = 40000
    steps  | method = "rk4", scaled_step = 0.1, max_segments = 40000
    leaps  | method = "leapfrog", scaled_step = 0.1, max_segments = 40000
    fine   | method = "rk4", scaled_step = 0.02, arc_tolerance = 1e-6, max_segments = 400000
    sharp  | method = "rk4", scaled_step = 0.1, arc_tolerance = 1e-7, max_segments = 40000
    planar | method = "planar", scaled_step = 0.2, max_segments = 40000
    round  | kind = "panorama", position = [0.3, 0.2, -0.1], look_at = [3, 0.5, 0.2]
    steep  | fov = 28, position = [0.3, 0.2, -0.1], look_at = [0.3, 3, -0.1], up = [1, 0, 0]
    aside  | kind = "panorama", position = [-1.3, 0.2, 0.1], look_at = [0.3, 0.1, 0]
    front  | fov = 60, position = [-1.3, 0.2, 0.1], look_at = [0.3, 0.1, 0]
    inside | kind = "panorama", position = [0.4, 0.2, 0.1], look_at = [3, 0.5, 0]
    ball   | { shape = "sphere", radius = 2, material = "wall" }
    room   | { shape = "sphere", radius = 2, material = "wall" }, { shape = "box", material = "wall", scale = 0.4, rotate = [20, 30, 0], translate = [1.1, 0.3, 0.2] }
    star   | { shape = "sphere", radius = 2, material = "wall" }, { shape = "sphere", material = "wall" }
    shell  | { shape = "sphere", radius = 2, material = "wall" }, { shape = "sphere", material = "bright" }
    glass  | { shape = "sphere", radius = 2, material = "wall" }, { shape = "box", rotate = [20, 35, 10], translate = [0.3, 0.1, 0], interior = { kind = "maxwell-fisheye", n0 = 1.5, a = 2 } }
    mirror | { shape = "sphere", radius = 2, material = "wall" }, { shape = "disk", center = [0, -0.3, 0], radius = 2.1, material = "mirror" }, { shape = "disk", center = [0, -0.35, 0], radius = 2.1, material = "dark" }
    pipe   | { shape = "cylinder", axis = [0, 0, 1], radius = 1.2, height = 3, material = "wall" }, { shape = "disk", center = [0, 0, -1], normal = [0, 0, 1], radius = 1.3, material = "mirror" }, { shape = "disk", center = [0, 0, 1], normal = [0, 0, 1], radius = 1.3, material = "mirror" }
    sky    | { shape = "plane", center = [0, 0.5, 0], size = [4, 4], material = "wall" }, { shape = "box", min = [-1, -0.5, -1], max = [1, 1, 1], material = "mirror" }
    cube   | { shape = "sphere", radius = 2, material = "wall" }, { shape = "box", min = [0.4, -2.1, -2.1], max = [2.1, 2.1, 2.1], interior = 1.2 }, { shape = "box", min = [-2.1, -2.1, -2.1], max = [-0.4, 2.1, 2.1], interior = 1.2 }, { shape = "box", min = [-2.1, 0.4, -2.1], max = [2.1, 2.1, 2.1], interior = 1.2 }, { shape = "box", min = [-2.1, -2.1, -2.1], max = [2.1, -0.4, 2.1], interior = 1.2 }, { shape = "box", min = [-2.1, -2.1, 0.4], max = [2.1, 2.1, 2.1], interior = 1.2 }, { shape = "box", min = [-2.1, -2.1, -2.1], max = [2.1, 2.1, -0.4], interior = 1.2 }
    sphere | shape = "sphere", radius = 0.8, center = [0.3, 0.1, 0]
    box    | shape = "box", rotate = [20, 35, 10], translate = [0.3, 0.1, 0]
    rod    | shape = "cylinder", radius = 0.7, height = 1.2, axis = [0.2, 0, 1], center = [0.3, 0.1, 0]
"#;

fn rows(table: &str) -> impl Iterator<Item = Vec<&str>> {
    table.lines().filter(|line| !line.is_empty()).map(|line| line.split(" | ").map(str::trim).collect())
}

/// Returns samples of an index: 1.5 at r² = 0.14, 1.3 along the whole border, and arbitrary values between.
fn samples() -> Vec<u8> {
    let index = |i: u32| match [i % 13, i / 13 % 13, i / 169] {
        [6, 6, 6] => 1.5,
        at if at.iter().all(|k| (3..10).contains(k)) => 1.3 + 0.3 * (i * 7919 % 1009) as f32 / 1009.0,
        _ => 1.3,
    };
    (0..13 * 13 * 13).flat_map(|i| index(i).to_le_bytes()).collect()
}

/// Checks the radiance of every pixel, and that no path is lost, because a lost dark path would not affect its pixel.
fn check(table: &str, size: [u32; 2], samples_a_pixel: u32, law_and_objects: fn(&str, &str) -> [String; 2]) {
    let paths = ["lighting = \"path-tracing\", ", "path_tracing = { rr_depth = 100000, light_sampling = false }\n"];
    check_lit(table, size, samples_a_pixel, (paths, [1.0, 0.5, 0.3]), law_and_objects);
}

/// Checks a table with a kind of lighting under which walls show a radiance.
fn check_lit(
    table: &str,
    size: [u32; 2],
    samples_a_pixel: u32,
    ([lighting, settings], shown): ([&str; 2], [f64; 3]),
    law_and_objects: fn(&str, &str) -> [String; 2],
) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("index.raw"), samples()).unwrap();
    let grid = format!(
        "{{ kind = \"grid\", file = '{}', size = [13, 13, 13], type = \"f32\", min = [-0.9, -1, -1.3], max = [1.5, 1.4, 1.1] }}",
        folder.path().join("index.raw").display()
    );
    let word = |word: &str| rows(WORDS).find(|row| row[0] == word).unwrap()[1];
    let (gpu, mut wrong) = (gpu(), Vec::new());
    for row in rows(table) {
        let [rays, camera, objects] = [0, 1, 2].map(|k| word(row[k]));
        let [law, objects] = law_and_objects(&row[4].replace("GRID", &grid), objects);
        let brighter = Formula::parse(row[3]).unwrap_or_else(|error| panic!("{error:?}")).value(DVec3::ZERO);
        let text = format!(
            "image = {{ size = {size:?}, samples = {samples_a_pixel} }}\ncamera = {{ {camera} }}\nlaw = {law}\n\
             rays = {{ bounding_sphere = {{ radius = 4 }}, {lighting}{rays} }}\n{settings}\
             objects = [{objects}]\n[materials]\nmirror = {{ kind = \"mirror\" }}\ndark = {{ kind = \"phong\", diffuse = [0, 0, 0] }}\n\
             wall = {{ kind = \"phong\", ambient = 0, diffuse = [0.5, 0.2, 0], emission = [0.5, 0.4, 0.3] }}\n\
             # Where n² is four times as large.\nbright = {{ kind = \"phong\", ambient = 0, diffuse = [0.5, 0.2, 0], emission = [2, 1.6, 1.2] }}\n"
        );
        let picture = Renderer::new(&gpu, &scene(&text), RenderSettings::default()).unwrap().render().unwrap();
        let mut off = 0.0_f64;
        for (values, radiance) in picture.band.color.iter().zip(shown) {
            let each = values.iter().map(|value| (f64::from(*value) / (radiance * brighter) - 1.0).abs());
            // NaN is the largest error.
            off = each.map(|off| if off.is_nan() { f64::INFINITY } else { off }).fold(off, f64::max);
        }
        let totals = &picture.totals;
        let lost = totals.rays - totals.count(Status::Hit) - totals.count(Status::Cut);
        if off > 4e-6 || lost > 0 {
            wrong.push(format!("off by {off:.1e}, {lost} paths lost ({totals})\n{text}"));
        }
    }
    assert!(wrong.is_empty(), "{} furnaces:\n{}", wrong.len(), wrong.join("\n"));
}

fn as_written(law: &str, objects: &str) -> [String; 2] {
    [law, objects].map(str::to_owned)
}

#[test]
fn every_law() {
    check(LAWS, [12, 8], 2, as_written);
}

/// Without path tracing, walls show their emission, and L/n² is constant as well.
#[test]
fn every_medium_without_path_tracing() {
    let emission = [0.5, 0.4, 0.3];
    check_lit(SPACES, [6, 4], 1, (["", ""], emission), |medium, walls| {
        [format!("{{ kind = \"medium\", index = {medium} }}"), walls.to_owned()]
    });
}

#[test]
fn every_medium_as_space() {
    check(SPACES, [12, 8], 2, |medium, walls| [format!("{{ kind = \"medium\", index = {medium} }}"), walls.to_owned()]);
}

#[test]
fn every_medium_in_a_clear_thing() {
    check(INTERIORS, [12, 8], 2, |medium, thing| {
        let wall = "{ shape = \"sphere\", radius = 2, material = \"wall\" }";
        ["{ kind = \"straight\" }".to_owned(), format!("{wall}, {{ {thing}, interior = {medium} }}")]
    });
}

#[test]
fn light_that_bends_back_stays_on_its_side() {
    check(RETURNS, [24, 16], 8, as_written);
}
