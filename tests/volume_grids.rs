//! Tests volumes whose matter is given by samples on grids.

use std::fmt::Write as _;
use std::path::Path;

use bentray::scene::Scene;
use glam::DVec3;

use crate::shaders::Random;
use crate::volumes::lights_of;

/// Writes samples of a function over a box as an NRRD file.
fn sampled(path: &Path, size: [u32; 3], [lo, hi]: [DVec3; 2], of: impl Fn(DVec3) -> f64) {
    let steps = (hi - lo) / DVec3::from_array(size.map(|n| f64::from(n - 1)));
    let [nx, ny, nz] = size;
    let mut bytes = format!(
        "NRRD0004\ntype: float\ndimension: 3\nsizes: {nx} {ny} {nz}\nencoding: raw\nendian: little\nspacings: {} {} {}\n\n",
        steps.x, steps.y, steps.z
    )
    .into_bytes();
    for (k, j, i) in (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| (k, j, i)))) {
        let x = lo + steps * DVec3::new(i.into(), j.into(), k.into());
        bytes.extend((of(x) as f32).to_le_bytes());
    }
    std::fs::write(path, bytes).unwrap();
}

fn rays(count: usize) -> Vec<[f64; 6]> {
    let mut random = Random::new(37);
    let ray = |_| {
        let n = random.direction();
        let aim = DVec3::new(random.within(-1.5, 1.5), random.within(-1.5, 1.5), random.within(-1.5, 1.5));
        let x = aim + 12.0 * n;
        [x.x, x.y, x.z, -n.x, -n.y, -n.z]
    };
    (0..count).map(ray).collect()
}

/// A function that is linear along each axis has the same light by samples and by formula, also about a volume's own center and around a
/// spinning black hole; a Gaussian differs by the curvature within a cell.
#[test]
fn samples_shine_as_their_function() {
    let folder = tempfile::tempdir().unwrap();
    let place = [DVec3::new(-2.0, -2.5, -3.0), DVec3::new(2.0, 2.5, 3.0)];
    sampled(&folder.path().join("a.nrrd"), [3, 2, 4], place, |x| (3.0 + x.x) * (4.0 - x.y) * (0.2 * x.z + 1.0));
    sampled(&folder.path().join("b.nrrd"), [65, 65, 97], place, |x| (-x.length_squared()).exp());
    let corners = "min = [-2, -2.5, -3], max = [2, 2.5, 3]";
    let kerr = "[law]\nkind = \"kerr-newman\"\nspin = 0.05\nmass = 0.1\n";
    for (law, center) in [("", [0.0, 0.0, 0.0]), ("", [1.0, -0.5, 0.5]), (kerr, [0.0, 0.0, 0.0])] {
        for (file, formula, bound) in
            [("a", "(3 + x)*(4 - y)*(0.2*z + 1)", 2e-4), ("b", "exp(-(x^2 + y^2 + z^2))", 5e-3)]
        {
            let flow = if law.is_empty() { "static" } else { "zamo" };
            let of = |grids: &str, density: &str| {
                let text = format!(
                    "{law}[rays]\nbounding_sphere = {{ radius = 30 }}\n[radiation]\nfrequencies = [1.0]\n[[volumes]]\nshape = \"box\"\n\
                     center = {center:?}\nsize = [4, 5, 6]\n{grids}density = \"{density}\"\nemission = 0.3\nabsorption = 0.05\n\
                     flow = \"{flow}\"\n"
                );
                let scene = Scene::parse(&text, &folder.path().join("scene.toml"), &[])
                    .unwrap_or_else(|error| panic!("{error}"));
                let (lights, totals) = lights_of(&scene, &rays(200));
                assert_eq!((totals.unsettled, totals.undefined), (0, 0), "{totals}");
                lights
            };
            let mut grids = String::new();
            writeln!(grids, "grids = {{ amount = {{ file = \"{file}.nrrd\", {corners} }} }}").unwrap();
            let (found, expected) = (of(&grids, "amount"), of("", formula));
            for (ray, (found, expected)) in found.iter().zip(&expected).enumerate() {
                let (one, two) = (found[0].intensity, expected[0].intensity);
                assert!((one - two).abs() < bound * two.max(0.05), "{law}{center:?} {file} {ray}: {one} {two}");
            }
        }
    }
}

#[test]
fn wrong_grids_are_explained() {
    let folder = tempfile::tempdir().unwrap();
    sampled(&folder.path().join("a.nrrd"), [2, 2, 2], [DVec3::ZERO, DVec3::ONE], |x| x.x - 2.0);
    let own = "grids = { g = { file = \"a.nrrd\", min = [-1, -1, -1], max = [1, 1, 1] } }\n";
    let cube = "shape = \"box\"\nsize = [2, 2, 2]\n";
    for (volume, problem, help) in [
        (own.to_owned(), "a grid covers a part of space, and this volume is all of it", "add shape"),
        (format!("shape = \"box\"\nsize = [3, 2, 2]\n{own}"), "a grid of it only from", "choose a smaller shape"),
        (format!("{cube}grids = {{ g = {{ file = \"b.nrrd\" }} }}\n"), "b.nrrd", ""),
        (format!("{cube}grids = {{ g = {{ file = \"a.raw\" }} }}\n"), "missing key", "size"),
        (format!("{cube}{}", own.replace("{ g =", "{ x =")), "`x` is already defined", ""),
        (format!("{cube}grids = 3\n"), "expected a table", ""),
    ] {
        let text = format!("[rays]\nbounding_sphere = {{ radius = 20 }}\n[[volumes]]\n{volume}emission = 1\n");
        let scene = Scene::parse(&text, &folder.path().join("scene.toml"), &[]);
        let said = scene.expect_err(&text).to_string();
        assert!(said.contains(problem) && said.contains(help) && said.contains("scene.toml:"), "{text}{said}");
    }
    // Samples may be negative, and matter may not.
    let text =
        format!("[rays]\nbounding_sphere = {{ radius = 20 }}\n[[volumes]]\n{cube}{own}density = \"g\"\nemission = 1\n");
    let scene = Scene::parse(&text, &folder.path().join("scene.toml"), &[]).unwrap();
    let warned = scene.warnings().join("\n");
    assert!(
        warned.contains("volumes[0]: the density is -") && warned.contains("let the density be 0 there"),
        "{warned}"
    );
}
