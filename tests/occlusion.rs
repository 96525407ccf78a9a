//! Tests ambient occlusion against projected areas in closed form.

use bentray::program::{ProgramOptions, Schedule};
use bentray::render::{RenderSettings, Renderer, Rendering};

use crate::support::{gpu, mean_of, scene};

fn rendered(text: &str, options: ProgramOptions) -> Rendering {
    Renderer::new(&gpu(), &scene(text), RenderSettings { options, ..RenderSettings::default() })
        .unwrap()
        .render()
        .unwrap()
}

/// Returns a scene with a white floor, seen from so near that all pixels show one point.
fn floor(ambient: &str, objects: &str, x: f64) -> String {
    format!(
        "[image]\nsize = [16, 16]\nsamples = 64\n[camera]\nkind = \"orthographic\"\nheight = 1e-5\nposition = [{x}, 0.002, 0]\n\
         look_at = [{x}, 0, 0]\nup = [0, 0, 1]\n[rays]\nbounding_sphere = {{ radius = 450 }}\n[ambient]\n{ambient}\n\
         [materials.m]\nkind = \"phong\"\ndiffuse = [1, 0.5, 0]\nambient = 1\n\
         [[objects]]\nshape = \"box\"\nmaterial = \"m\"\ncenter = [0, -1, 0]\nsize = [400, 2, 400]\n{objects}"
    )
}

const BALL: &str = "[[objects]]\nshape = \"sphere\"\ncenter = [0, 1, 0]\nradius = 1\n";
/// A ball above the visible point and the camera.
const RAISED: &str = "[[objects]]\nshape = \"sphere\"\ncenter = [0, 1.2, 0]\nradius = 1\n";
const WALL: &str = "[[objects]]\nshape = \"box\"\nmaterial = \"m\"\ncenter = [1.5, 25, 0]\nsize = [2, 50, 400]\n";

#[test]
fn what_is_open_is_as_bright() {
    let opaque = format!("{BALL}material = \"m\"\n");
    let glass = format!("{BALL}interior = 1.5\n");
    let disk = "[[objects]]\nshape = \"disk\"\nmaterial = \"m\"\ncenter = [0, 1, 0]\nradius = 1\n";
    for (ambient, objects, x, open) in [
        ("", &*opaque, 1.0, 0.646_446_6),
        ("", &*opaque, 2.5, 0.948_773_7),
        ("", disk, 0.0, 0.5),
        ("", disk, 1.5, 0.873_704_7),
        ("distance = 1", WALL, 0.0, 0.804_498_9),
        ("", &*glass, 1.0, 0.646_446_6),
        ("transparent = \"ignored\"", &*glass, 1.0, 1.0),
        ("floor = 0.25", &*opaque, 1.0, 0.25 + 0.75 * 0.646_446_6),
    ] {
        let picture = rendered(&floor(ambient, objects, x), ProgramOptions::default());
        let (mean, error) = mean_of(&picture, 0);
        assert!((mean - open).abs() < 4.0 * error + 1e-5, "{ambient}, {objects}: {mean} ± {error} for {open}");
        assert!(error < 0.01 * open, "{objects}: {error}");
    }
}

/// Lights shine through glass, whatever its effect on ambient light.
#[test]
fn glass_casts_no_shadow_of_lights() {
    let light = "[[lights]]\nkind = \"directional\"\ndirection = [0, -1, 0]\nshadows = \"straight-rays\"\n";
    for gloss in [
        "interior = 1.5\n",
        "interior = { kind = \"constant\", n = 1.5, transmit_exponent = 100 }\n",
        "interior = { kind = \"constant\", n = 1.5, roughness = 0.3 }\n",
    ] {
        let text = format!("{}{light}", floor("floor = 1", &format!("{BALL}{gloss}"), 0.5));
        let (mean, _) = mean_of(&rendered(&text, ProgramOptions::default()), 0);
        // Ambient light, and a light that faces the floor.
        assert!((mean - 2.0).abs() < 1e-4, "{gloss}: {mean}");
    }
}

/// Each light, and ambient light, specifies separately whether transparent objects occlude it.
#[test]
fn clear_things_shut_out_what_asks_for_it() {
    let light = |shadows: &str, part: f64| {
        format!(
            "[[lights]]\nkind = \"directional\"\ndirection = [0, -1, 0]\ncolor = [{part}, {part}, {part}]\n{shadows}"
        )
    };
    let all = [
        light("shadows = \"none\"\n", 1.0),
        light("shadows = \"straight-rays\"\n", 0.5),
        light("shadows = \"straight-rays\"\ntransparent = \"opaque\"\n", 0.25),
    ];
    for gloss in [
        "interior = 1.5\n",
        "interior = { kind = \"constant\", n = 1.5, transmit_exponent = 100 }\n",
        "material = \"m\"\n",
    ] {
        for ambient in ["floor = 1", "floor = 1\ntransparent = \"ignored\""] {
            let text = format!("{}{}", floor(ambient, &format!("{BALL}{gloss}"), 0.5), all.concat());
            let (mean, _) = mean_of(&rendered(&text, ProgramOptions::default()), 0);
            let expected = if gloss.starts_with("material") { 2.0 } else { 2.5 };
            assert!((mean - expected).abs() < 1e-4, "{gloss}, {ambient}: {mean}");
        }
        // Next to the ball no light is occluded.
        let text = format!("{}{}", floor("floor = 1", &format!("{BALL}{gloss}"), 3.0), all.concat());
        let (mean, _) = mean_of(&rendered(&text, ProgramOptions::default()), 0);
        assert!((mean - 2.75).abs() < 1e-4, "{gloss}: {mean}");
    }
}

/// The fraction of light that glass of index 1.5 transmits at normal incidence, through both of its sides.
const THROUGH: f64 = 0.96 * 0.96;

/// Renders a floor that is seen next to the objects on it, lit by one light alone.
fn lit(law: &str, objects: &str, light: &str) -> Rendering {
    let text = floor("floor = 1", objects, 0.0).replace("ambient = 1", "ambient = 0");
    let text = text.replace("[ambient]\nfloor = 1\n", law).replace("diffuse = [1, 0.5, 0]", "diffuse = [1, 1, 1]");
    rendered(
        &format!("{text}[[lights]]\n{light}shadows = \"straight-rays\"\ntransparent = \"tinted\"\n"),
        ProgramOptions::default(),
    )
}

#[test]
fn clear_things_weaken_light_on_straight_lines() {
    let above = "kind = \"directional\"\ndirection = [0, -1, 0]\n";
    let slanting = "kind = \"directional\"\ndirection = [0, -0.6, 0.8]\n";
    let near = "kind = \"point\"\nposition = [0, 3, 0]\n";
    let (c, s) = (0.6_f64, 0.8_f64);
    // The Fresnel equations for a ray of sine s, without angles.
    let inside = (1.0 - (s / 1.5_f64).powi(2)).sqrt();
    let [r1, r2] = [(c - 1.5 * inside) / (c + 1.5 * inside), (1.5 * c - inside) / (1.5 * c + inside)];
    let slanted = 1.0 - 0.5 * (r1 * r1 + r2 * r2);
    let slab = |interior: &str| {
        format!(
            "[[objects]]\nshape = \"box\"\ncenter = [0, 1.5, 0]\nsize = [20, 1, 20]\ninterior = {{ kind = \"constant\", {interior} }}\n"
        )
    };
    let ball = |filter: &str| format!("{RAISED}interior = {{ kind = \"constant\", n = 1.5, absorption = {filter} }}\n");
    let cases = [
        (slab("n = 1.5"), above, "", [THROUGH; 3]),
        (slab("n = 1.5, transmit_exponent = 50"), above, "", [THROUGH; 3]),
        (slab("n = 1.5, absorption = [0.5, 0.25, 1]"), near, "", [0.5 * THROUGH, 0.25 * THROUGH, THROUGH]),
        (
            slab("n = 1.5, absorption = [0.5, 1, 0]"),
            slanting,
            "",
            [0.5_f64.powf(1.0 / c), 1.0, 0.0].map(|t| c * t * slanted * slanted),
        ),
        // Between equal indices only absorption remains.
        (slab("n = 1, absorption = [0.5, 1, 0.2]"), above, "", [0.5, 1.0, 0.2]),
        (
            ball("{ coefficient = [\"0.1 + 0.4*r^2\", \"0.3\", \"exp(-y)\"] }"),
            above,
            "",
            [
                THROUGH * (-0.2 - 0.8_f64 / 3.0).exp(),
                THROUGH * (-0.6_f64).exp(),
                THROUGH * (-2.0 * 1.0_f64.sinh()).exp(),
            ],
        ),
        // Only through space, down to the floor; and the camera is 0.002 above it.
        (String::new(), near, "absorption = [0.9, 0.5, 1]\n", [0.9_f64.powf(3.002), 0.5_f64.powf(3.002), 1.0]),
        // Two objects, and the space around them.
        (
            format!(
                "{}{}",
                slab("n = 1.5, absorption = [0.5, 0.5, 0.5]"),
                slab("n = 1.5").replace("1.5, 0]", "2.5, 0]").replace("[20, 1, 20]", "[20, 0.5, 20]")
            ),
            near,
            "absorption = [0.5, 1, 1]\n",
            [0.5_f64.powf(2.502), 0.5, 0.5].map(|t| t * THROUGH * THROUGH),
        ),
        (format!("{RAISED}material = \"m\"\n"), above, "", [0.0; 3]),
    ];
    for (objects, light, law, expected) in cases {
        let law = if law.is_empty() { String::new() } else { format!("[law]\nkind = \"straight\"\n{law}") };
        let picture = lit(&law, &objects, light);
        for (channel, expected) in expected.into_iter().enumerate() {
            let (mean, _) = mean_of(&picture, channel);
            assert!(
                (mean - expected).abs() < 1e-3 * expected + 1e-6,
                "{objects}{light}{law} {channel}: {mean} for {expected}"
            );
        }
    }
}

/// Each light has a separate setting for transparent objects, and so has ambient light.
#[test]
fn lights_of_all_kinds_share_a_scene() {
    let light = |part: f64, clear: &str| {
        format!(
            "[[lights]]\nkind = \"directional\"\ndirection = [0, -1, 0]\ncolor = [{part}, {part}, {part}]\nshadows = \"straight-rays\"\ntransparent = \"{clear}\"\n"
        )
    };
    let glass = format!("{RAISED}interior = {{ kind = \"constant\", n = 1.5, absorption = [0.5, 0.5, 0.5] }}\n");
    let lights = [light(1.0, "ignored"), light(0.5, "tinted"), light(0.25, "opaque")].concat();
    let text = format!("{}{lights}", floor("floor = 1", &glass, 0.0));
    let (mean, _) = mean_of(&rendered(&text, ProgramOptions::default()), 0);
    let expected = 1.0 + 1.0 + 0.5 * 0.25 * THROUGH;
    assert!((mean - expected).abs() < 1e-3, "{mean} for {expected}");
    // A dome of glass over the point: all ambient light crosses it at normal incidence.
    let dome = glass.replace("center = [0, 1.2, 0]", "center = [0, 0, 0]");
    let (mean, error) =
        mean_of(&rendered(&floor("transparent = \"tinted\"", &dome, 0.0), ProgramOptions::default()), 0);
    let expected = 0.96 * 0.5;
    assert!((mean - expected).abs() < 4.0 * error + 2e-3, "{mean} ± {error} for {expected}");
}

/// Returns a scene with a white floor under a black ball and next to a black wall, seen from above.
fn bent_scene(law: &str, more: &str) -> String {
    format!(
        "[image]\nsize = [24, 18]\nsamples = 256\n[camera]\nkind = \"pinhole\"\nposition = [0, 6, 12]\nlook_at = [0, 1, 0]\nfov = 50\n\
         [rays]\nmethod = \"dormand-prince\"\ntolerance = 1e-5\nbounding_sphere = {{ radius = 40 }}\n{law}{more}\
         [materials.white]\ndiffuse = [1, 1, 1]\nspecular = [0, 0, 0]\n\
         [materials.black]\ndiffuse = [0, 0, 0]\nspecular = [0, 0, 0]\n\
         [[objects]]\nshape = \"box\"\nmaterial = \"white\"\ncenter = [0, -2, 0]\nsize = [12, 1, 12]\n\
         [[objects]]\nshape = \"sphere\"\nmaterial = \"black\"\ncenter = [3, 0, 2]\nradius = 1.2\n\
         [[objects]]\nshape = \"box\"\nmaterial = \"black\"\ncenter = [-3, 1, -3]\nsize = [1, 5, 6]\n"
    )
}

/// Compares ambient occlusion with one bounce of path tracing under a white sky; other tests check the paths.
#[test]
fn bent_paths_find_as_much_open() {
    let hole = "[law]\nkind = \"schwarzschild\"\ncenter = [0, 2.5, 0]\nmass = 0.3\n";
    let force = "[law]\nkind = \"sources\"\n[[law.sources]]\nkind = \"center\"\nposition = [1, 3, 1]\nstrength = 1.6\nfalloff = \"inverse-square\"\n\
                 [[law.sources]]\nkind = \"line\"\nposition = [-1, 0, 4]\ndirection = [0, 1, 0]\nstrength = -1\nfalloff = { cubic = 5 }\n";
    for law in [hole, force] {
        let lit = |ambient: &str| {
            rendered(&bent_scene(law, ambient).replace("specular", "ambient = 1\nspecular"), ProgramOptions::default())
        };
        let [open, straight, whole] = ["[ambient]\nrays = \"law\"\n", "[ambient]\n", ""].map(lit);
        let more = "[path_tracing]\nmax_depth = 1\nlight_sampling = false\n[sky]\ncolor = [1, 1, 1]\n";
        let paths =
            rendered(&bent_scene(&format!("lighting = \"path-tracing\"\n{law}"), more), ProgramOptions::default());
        let at = |picture: &Rendering, i: usize| f64::from(picture.band.color[0][i]);
        // Pixels that only show the floor.
        let floor: Vec<usize> = (0..24 * 18).filter(|i| at(&whole, *i) > 0.9999).collect();
        let seen = floor.len() as f64;
        // Both values are means of that many independent zeros and ones.
        let squares = |picture: &Rendering| {
            let square = |i: &usize| {
                let p = at(&open, *i);
                (p - at(picture, *i)).powi(2) / (2.0 * (p * (1.0 - p)).max(0.02) / 256.0)
            };
            floor.iter().map(square).sum::<f64>()
        };
        let (off, from_straight) = (squares(&paths), squares(&straight));
        assert!(seen > 20.0, "{law}: {seen}");
        assert!(off < seen + 5.0 * (2.0 * seen).sqrt(), "{law}: {off} for {seen}");
        // Both used identical random directions, and would be bit-identical without bending.
        assert!(from_straight > 0.3 * seen, "{law}: along straight lines it is {from_straight} for {seen}");
    }
}

#[test]
fn every_schedule_sees_the_same() {
    let text = floor("", &format!("{BALL}material = \"m\"\n"), 1.2).replace("samples = 64", "samples = 3");
    let usual = rendered(&text, ProgramOptions::default());
    for schedule in Schedule::ALL {
        assert!(
            rendered(&text, ProgramOptions { schedule, ..ProgramOptions::default() }).band == usual.band,
            "{schedule:?}"
        );
    }
}
