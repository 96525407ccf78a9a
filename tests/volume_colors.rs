//! Tests the light of volumes in color.

use bentray::program::Schedule;
use bentray::render::{RenderSettings, Renderer};

use crate::support::{gpu, scene};
use crate::volumes::{EYE, intensities, picture};

/// A uniform ball of emission j and absorption κ adds j/κ (1 − e^(−κ d)) to each color channel, and weakens the sky behind it by e^(−κ d).
#[test]
fn colors_follow_the_same_law() {
    let text = "[image]\nsize = [1, 1]\n[camera]\nposition = [0, 0, 10]\nfov = 0.01\n[sky]\ncolor = [0.5, 0.5, 0.5]\n\
                [rays]\nbounding_sphere = { radius = 20 }\n[[volumes]]\nshape = \"sphere\"\nradius = 1.5\n\
                emission = [0.2, 0.1, 0.05]\nabsorption = [\"0.3\", \"0.6\", \"1.2\"]\n";
    let found = Renderer::new(&gpu(), &scene(text), RenderSettings::default()).unwrap().render().unwrap();
    for (k, (j, absorption)) in [(0.2, 0.3), (0.1, 0.6), (0.05, 1.2)].into_iter().enumerate() {
        let passes = f64::exp(-3.0 * absorption);
        let expected = j / absorption * (1.0 - passes) + 0.5 * passes;
        assert!((f64::from(found.band.color[k][0]) / expected - 1.0).abs() < 1e-5, "{k}");
    }
}

/// Matter whose coefficients do not depend on the frequency has the same light in color as at one frequency, by every motion, down to the
/// horizon.
#[test]
fn colors_are_intensities() {
    let matter = "[[volumes]]\nshape = \"sphere\"\nradius = 15\ndensity = \"exp(-(r/6)^2)*max(0, 1 - (z/4)^2)\"\nemission = \"n\"\n\
                  absorption = \"0.2*n\"\nflow = \"zamo\"\n";
    let radiation = "[radiation]\nfrequencies = [1.0]\ntolerance = 1e-3\n";
    for (law, method) in [
        ("kerr-newman\"\nspin = \"0.7", "separated"),
        ("kerr-newman\"\nspin = \"0.7", "dormand-prince"),
        ("schwarzschild", "planar"),
        ("schwarzschild", "rk4"),
    ] {
        let head = format!(
            "[image]\nsize = [24, 16]\n{EYE}[law]\nkind = \"{law}\"\n[rays]\nbounding_sphere = {{ radius = 100 }}\nmethod = \"{method}\"\n"
        )
        .replace("spin = \"0.7\"", "spin = 0.7");
        let expected = picture(&format!("{head}{radiation}{matter}"), Schedule::Whole);
        let (gpu, colored) = (gpu(), scene(&format!("{head}{matter}")));
        for schedule in [Schedule::Whole, Schedule::Segment] {
            let options = bentray::program::ProgramOptions { schedule, ..Default::default() };
            let settings = RenderSettings { options, ..RenderSettings::default() };
            let found = Renderer::new(&gpu, &colored, settings).unwrap().render().unwrap();
            let brightest = intensities(&expected).iter().copied().fold(0.0, f32::max);
            assert!(brightest > 1.0 && found.totals.unsettled == 0, "{method}: {brightest} {}", found.totals);
            for channel in &found.band.color {
                for (i, (one, two)) in channel.iter().zip(intensities(&expected)).enumerate() {
                    assert!((one - two).abs() < 2e-3 * brightest, "{method} {schedule:?} {i}: {one} {two}");
                }
            }
        }
    }
}

/// Opaque matter of one temperature has the color of the material `blackbody`, also where gravity shifts its light.
#[test]
fn opaque_matter_has_the_color_of_a_black_body() {
    let head = "[image]\nsize = [1, 1]\n[camera]\nposition = [0, 0, 12]\nfov = 0.1\nobserver = \"static\"\nredshift = true\n[law]\n\
                kind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 20 }\nmethod = \"planar\"\n";
    let color = |text: &str| {
        let found = Renderer::new(&gpu(), &scene(text), RenderSettings::default()).unwrap().render().unwrap();
        [0, 1, 2].map(|k| found.band.color[k][0])
    };
    let surface = color(&format!(
        "{head}[materials.hot]\nkind = \"blackbody\"\ntemperature = 4000\n[[objects]]\nshape = \"sphere\"\nradius = 4\nmaterial = \"hot\"\n"
    ));
    let matter = color(&format!(
        "{head}[[volumes]]\nshape = \"sphere\"\nradius = 4\nsource = {{ black_body = 4000, white = 4000 }}\nabsorption = 1e4\n"
    ));
    for (one, two) in matter.into_iter().zip(surface) {
        assert!((one / two - 1.0).abs() < 2e-3, "{matter:?} {surface:?}");
    }
}
