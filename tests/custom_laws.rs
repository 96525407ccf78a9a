//! Tests laws in a WGSL file of the scene: they are as good as built-in laws, and their errors are clear.

use std::path::Path;

use bentray::gpu::Geometry;
use bentray::program::{Program, ProgramOptions, part};
use bentray::render::{RenderSettings, Renderer, Status, trace};
use bentray::scene::{Scene, SceneError};

use crate::support::{gpu, shipped_scenes};

/// Returns a scene with this law and these lines in the table of its law.
fn scene_with(folder: &Path, wgsl: &str, law: &str, rays: &str) -> Scene {
    loaded(folder, wgsl, law, rays).unwrap_or_else(|error| panic!("{error}"))
}

fn loaded(folder: &Path, wgsl: &str, law: &str, rays: &str) -> Result<Scene, SceneError> {
    std::fs::write(folder.join("law.wgsl"), wgsl).unwrap();
    let text = format!(
        "[image]\nsize = [48, 32]\n[camera]\nposition = [0, 1, 12]\nfov = 60\n[law]\nkind = \"wgsl\"\nfile = \"law.wgsl\"\n{law}\n\
         [rays]\nbounding_sphere = {{ radius = 30 }}\n{rays}\n[sky]\ncolor = [0.2, 0.4, 0.8]\n[materials.red]\nkind = \"emissive\"\n\
         color = [1, 0.2, 0.1]\n[[objects]]\nshape = \"sphere\"\nmaterial = \"red\"\ncenter = [4, 0, -3]\n"
    );
    let path = folder.join("scene.toml");
    std::fs::write(&path, text).unwrap();
    Scene::load(&path, &[])
}

fn error_of(wgsl: &str, law: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene_with(folder.path(), wgsl, law, "scaled_step = 0.1");
    let geometry = Geometry::new(&scene);
    match Program::new(&scene, &geometry.analysis, &ProgramOptions::default(), geometry.extent()) {
        Ok(_) => panic!("no error in\n{wgsl}"),
        Err(error) => error.to_string(),
    }
}

/// Checks the text of a built-in law, with its uniform declared as parameters.
#[test]
fn a_law_that_repeats_a_built_in_one_gives_its_picture_bit_by_bit() {
    let built_in = part("law/schwarzschild_path").unwrap().text;
    let functions = &built_in[built_in.find("fn law_").unwrap()..];
    let gpu = gpu();
    let folder = tempfile::tempdir().unwrap();
    for method in ["rk4", "rkn4", "dormand-prince", "euler-doubling"] {
        let rays = format!("method = \"{method}\"\nmax_segments = 4000");
        let parameters = "parameters = { center = [0, 0, 0], mass = 1 }\ncapture_spheres = [[0, 0, 0, 3]]";
        let own = scene_with(folder.path(), functions, parameters, &rays);
        let text = std::fs::read_to_string(folder.path().join("scene.toml")).unwrap();
        let text =
            text.replace(&format!("kind = \"wgsl\"\nfile = \"law.wgsl\"\n{parameters}"), "kind = \"schwarzschild\"");
        let known = Scene::parse(&text, Path::new("scene.toml"), &[]).unwrap();
        let picture =
            |scene: &Scene| Renderer::new(&gpu, scene, RenderSettings::default()).unwrap().render().unwrap().band;
        assert!(picture(&own) == picture(&known), "{method}");
    }
}

#[test]
fn what_is_wrong_with_a_law_is_said_at_its_place() {
    let place = "fn law_acceleration(x: Real3, held: Real) -> Real3 {\n    return BODY;\n}\n";
    let with = |body: &str| place.replace("BODY", body);
    let after = |more: &str| format!("{}{more}", with("-x"));
    for (name, wgsl, wanted) in [
        ("syntax", with("-x +"), "law.wgsl:2:"),
        ("an unknown name", with("nothing * x"), "law.wgsl:2:12: no definition in scope for identifier: `nothing`"),
        (
            "a missing function",
            "const A: f32 = 1.0;\n".to_owned(),
            "the file must declare `fn law_acceleration(x: Real3, held: Real) -> Real3`",
        ),
        (
            "a wrong signature",
            with("-x").replace("held: Real", "held: Real3"),
            "law.wgsl:1:4: expected `fn law_acceleration(x: Real3",
        ),
        (
            "a wrong result",
            with("-x").replace("-> Real3", "-> Real"),
            "law.wgsl:1:4: expected `fn law_acceleration(x: Real3",
        ),
        (
            "a binding",
            after("@group(0) @binding(5) var<uniform> mine: f32;\n"),
            "law.wgsl:4:1: attributes and bindings are not allowed here",
        ),
        (
            "a buffer",
            after("var<storage> mine: array<f32>;\n"),
            "law.wgsl:4:1: a module variable must be `var<private>`",
        ),
        (
            "an unbounded loop",
            with("-x").replace("return", "loop { }\n    return"),
            "law.wgsl:2:5: `loop` is not allowed, because it may never end",
        ),
        (
            "a sine of WGSL's own",
            with("-x").replace("return", "let s = x * Real3(f32(sin(f32(x.x))));\n    return"),
            "law.wgsl:2:27: the built-in `sin` is inaccurate in 32 bits and wrong in 64 bits: use `real_sin_cos(a)`",
        ),
        (
            "a while loop",
            with("-x").replace("return", "while x.x > 0.0 { }\n    return"),
            "law.wgsl:2:5: `while` is not allowed, because it may never end",
        ),
        (
            "a loop of unknown length",
            with("-x").replace("return", "for (var i = 0u; i < u32(x.x); i++) { }\n    return"),
            "law.wgsl:2:5: a loop must have constant bounds",
        ),
        (
            "a loop whose counter is set",
            with("-x").replace("return", "for (var i = 0u; i < 9u; i++) { i = 0u; }\n    return"),
            "law.wgsl:2:5: a loop must have constant bounds",
        ),
        (
            "a clash",
            after("fn law_captured() -> f32 {\n    return 1.0;\n}\n"),
            "law.wgsl:4:4: the name `law_captured` is reserved",
        ),
        (
            "a function of WGSL's own",
            after("fn dot(a: Real3, b: Real3) -> Real {\n    return 1.0;\n}\n"),
            "law.wgsl:4:4: the name `dot` is reserved",
        ),
        (
            "a huge array",
            with("-x")
                .replace("return", "var all: array<f32, 100000000>;\n    all[u32(x.x)] = 1.0;\n    return all[3] * "),
            "law.wgsl:2:",
        ),
        (
            "a huge variable",
            after("var<private> all: array<vec4f, 1000000>;\n").replace("-x", "-x * all[u32(x.x)].x"),
            "law.wgsl:4:",
        ),
        ("recursion", with("law_acceleration(x, held)"), "law.wgsl:1:4: "),
    ] {
        let error = error_of(&wgsl, "");
        assert!(error.contains(wanted), "{name}: {error}");
    }
}

#[test]
fn parameters_have_names_that_the_file_uses() {
    let folder = tempfile::tempdir().unwrap();
    let wgsl =
        "fn law_acceleration(x: Real3, held: Real) -> Real3 {\n    let all = law;\n    return -all.pull * x;\n}\n";
    for (parameters, wanted) in [
        ("pull = 1, push = 2", "the WGSL file of the law does not use `push`"),
        ("pull = 1, \"2x\" = 2", "`2x` is not a valid WGSL name"),
        ("pull = [1, 2, 3, 4, 5]", "expected a number, or an array of 2 to 4"),
    ] {
        let error =
            loaded(folder.path(), wgsl, &format!("parameters = {{ {parameters} }}"), "").unwrap_err().to_string();
        assert!(error.contains("scene.toml:9:") && error.contains(wanted), "{error}");
    }
    scene_with(folder.path(), wgsl, "parameters = { pull = 1 }", "");
}

/// A ray whose derivative is not finite fails, and does not show the sky.
#[test]
fn rays_that_a_law_makes_infinite_have_failed() {
    let gpu = gpu();
    let folder = tempfile::tempdir().unwrap();
    for body in ["sqrt(-1.0 - dot(x, x)) * x", "x / (dot(x, x) - dot(x, x))", "(1.0 / held) * x"] {
        let wgsl = format!("fn law_acceleration(x: Real3, held: Real) -> Real3 {{\n    return {body};\n}}\n");
        for method in ["rk4", "dormand-prince"] {
            let scene = scene_with(folder.path(), &wgsl, "", &format!("method = \"{method}\""));
            let rays = [[0.0, 1.0, 12.0, 0.0, 0.1, -1.0], [3.0, 1.0, 9.0, 0.3, 0.1, -1.0]];
            let (ends, totals) = trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
            let lost = [Status::Failed, Status::Stalled, Status::Exhausted];
            assert!(ends.iter().all(|end| lost.contains(&end.status)), "{body} by {method}: {ends:?}");
            assert_eq!(totals.unfollowed(), 2);
        }
    }
}

/// Checks a helix, dx = (−y, x, ½): about ten steps, each within a relative error of 1e-6.
#[test]
fn a_users_flow_is_followed() {
    let folder = tempfile::tempdir().unwrap();
    let wgsl = "fn flow_field(x: Real3) -> Real3 {\n    return Real3(-x.y, x.x, 0.5);\n}\n";
    std::fs::write(folder.path().join("law.wgsl"), wgsl).unwrap();
    let text = "law = { kind = \"wgsl\", file = \"law.wgsl\", depends = \"flow\" }\n\
                rays = { bounding_sphere = { radius = 30 }, max_parameter = 2, method = \"dormand-prince\", tolerance = 1e-6 }\n";
    let scene = Scene::parse(text, &folder.path().join("scene.toml"), &[]).unwrap();
    let (ends, _) = trace(&gpu(), &scene, &RenderSettings::default(), &[[3.0, 0.0, 0.0, 0.0, 0.0, 1.0]]).unwrap();
    let (sine, cosine) = 2_f64.sin_cos();
    for (found, expected) in ends[0].x.into_iter().zip([3.0 * cosine, 3.0 * sine, 1.0]) {
        assert!((found - expected).abs() < 3e-5, "{:?}", ends[0]);
    }
}

/// The interface that a law implements determines its methods; all of these can trace it.
#[test]
fn shipped_laws_are_followed_to_their_ends() {
    let gpu = gpu();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/laws");
    let scenes: Vec<_> = folder.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    let scenes: Vec<_> = scenes.into_iter().filter(|path| path.extension().is_some_and(|e| e == "toml")).collect();
    assert!(scenes.len() >= 5 && !shipped_scenes().is_empty());
    for path in scenes {
        let keys = ["image.size=[48, 32]", "image.samples=1", "rays.method=dormand-prince"];
        let keys: Vec<_> = keys.iter().map(|key| key.parse().unwrap()).collect();
        let scene = Scene::load(&path, &keys).unwrap_or_else(|error| panic!("{error}"));
        let totals = Renderer::new(&gpu, &scene, RenderSettings::default()).unwrap().render().unwrap().totals;
        assert!(totals.unfollowed() <= 3, "{}: {totals}", path.display());
    }
}
