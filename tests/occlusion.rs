//! Ambient light that things near a place shut out, against projected areas in closed form.

use bentray::program::{Choice, Schedule};
use bentray::render::{RenderSettings, Renderer, Rendering};

use crate::support::{gpu, scene};

fn rendered(text: &str, choice: Choice) -> Rendering {
    Renderer::new(&gpu(), &scene(text), RenderSettings { choice, ..RenderSettings::default() })
        .unwrap()
        .picture()
        .unwrap()
}

/// A white floor, seen from so near that all pixels show one place.
fn floor(ambient: &str, objects: &str, x: f64) -> String {
    format!(
        "[image]\nsize = [16, 16]\nsamples = 64\n[camera]\nkind = \"plane\"\nheight = 1e-5\nposition = [{x}, 0.002, 0]\n\
         look_at = [{x}, 0, 0]\nup = [0, 0, 1]\n[rays]\nbound = {{ radius = 450 }}\n[ambient]\n{ambient}\n\
         [materials.m]\nkind = \"phong\"\ndiffuse = [1, 0.5, 0]\nambient = 1\n\
         [[objects]]\nshape = \"box\"\nmaterial = \"m\"\ncenter = [0, -1, 0]\nsize = [400, 2, 400]\n{objects}"
    )
}

fn mean(picture: &Rendering, channel: usize) -> (f64, f64) {
    let all: Vec<f64> = picture.band.color[channel].iter().map(|x| f64::from(*x)).collect();
    let n = all.len() as f64;
    let mean = all.iter().sum::<f64>() / n;
    (mean, (all.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n * (n - 1.0))).sqrt())
}

const BALL: &str = "[[objects]]\nshape = \"sphere\"\ncenter = [0, 1, 0]\nradius = 1\n";
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
        ("clear = \"open\"", &*glass, 1.0, 1.0),
        ("floor = 0.25", &*opaque, 1.0, 0.25 + 0.75 * 0.646_446_6),
    ] {
        let picture = rendered(&floor(ambient, objects, x), Choice::default());
        let (mean, error) = self::mean(&picture, 0);
        assert!((mean - open).abs() < 4.0 * error + 1e-5, "{ambient}, {objects}: {mean} ± {error} for {open}");
        assert!(error < 0.01 * open, "{objects}: {error}");
    }
}

/// Lights shine through glass whatever that does to ambient light.
#[test]
fn glass_casts_no_shadow_of_lights() {
    let light = "[[lights]]\nkind = \"directional\"\ndirection = [0, -1, 0]\nshadows = \"straight\"\n";
    for gloss in ["interior = 1.5\n", "interior = { kind = \"constant\", n = 1.5, transmit_exponent = 100 }\n"] {
        let text = format!("{}{light}", floor("floor = 1", &format!("{BALL}{gloss}"), 0.5));
        let (mean, _) = self::mean(&rendered(&text, Choice::default()), 0);
        // Ambient light, and a lamp that faces it.
        assert!((mean - 2.0).abs() < 1e-4, "{gloss}: {mean}");
    }
}

/// Each light and ambient light say for themselves whether clear things shut them out.
#[test]
fn clear_things_shut_out_what_asks_for_it() {
    let light = |shadows: &str, part: f64| {
        format!(
            "[[lights]]\nkind = \"directional\"\ndirection = [0, -1, 0]\ncolor = [{part}, {part}, {part}]\n{shadows}"
        )
    };
    let all = [
        light("shadows = \"none\"\n", 1.0),
        light("shadows = \"straight\"\n", 0.5),
        light("shadows = \"straight\"\nclear = \"closed\"\n", 0.25),
    ];
    for gloss in [
        "interior = 1.5\n",
        "interior = { kind = \"constant\", n = 1.5, transmit_exponent = 100 }\n",
        "material = \"m\"\n",
    ] {
        for ambient in ["floor = 1", "floor = 1\nclear = \"open\""] {
            let text = format!("{}{}", floor(ambient, &format!("{BALL}{gloss}"), 0.5), all.concat());
            let (mean, _) = self::mean(&rendered(&text, Choice::default()), 0);
            let expected = if gloss.starts_with("material") { 2.0 } else { 2.5 };
            assert!((mean - expected).abs() < 1e-4, "{gloss}, {ambient}: {mean}");
        }
        // And beside the ball all of them.
        let text = format!("{}{}", floor("floor = 1", &format!("{BALL}{gloss}"), 3.0), all.concat());
        let (mean, _) = self::mean(&rendered(&text, Choice::default()), 0);
        assert!((mean - 2.75).abs() < 1e-4, "{gloss}: {mean}");
    }
}

#[test]
fn every_schedule_sees_the_same() {
    let text = floor("", &format!("{BALL}material = \"m\"\n"), 1.2).replace("samples = 64", "samples = 3");
    let usual = rendered(&text, Choice::default());
    for schedule in Schedule::ALL {
        assert!(rendered(&text, Choice { schedule, ..Choice::default() }).band == usual.band, "{schedule:?}");
    }
}
