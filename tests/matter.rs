//! Tests that matter is one kind, whether it fills a medium or a volume, and the mean redshift of its light.

use bentray::program::{Layer, ProgramOptions};
use bentray::render::{Plane, RenderSettings, Renderer, Rendering};

use crate::support::{gpu, scene};

fn rendered(text: &str, layers: &[Layer]) -> Rendering {
    let options = ProgramOptions { layers: layers.to_vec(), ..ProgramOptions::default() };
    Renderer::new(&gpu(), &scene(text), RenderSettings { options, ..RenderSettings::default() })
        .unwrap()
        .render()
        .unwrap()
}

fn assert_close(one: &Rendering, two: &Rendering, bound: f32, name: &str) {
    let all = || one.band.color.iter().flatten().zip(two.band.color.iter().flatten());
    assert!(all().any(|(one, _)| *one > 0.05), "{name}");
    let off = all().map(|(one, two)| (one - two).abs()).fold(0.0, f32::max);
    assert!(off < bound, "{name}: {off}");
}

const VIEW: &str =
    "[image]\nsize = [12, 8]\n[camera]\nposition = [9, 1, 2]\nup = [0, 0, 1]\nfov = 40\n[sky]\ncolor = [1, 0.8, 0.5]\n";

/// All of space with the same matter: as a medium, and as a volume.
#[test]
fn media_are_volumes() {
    let medium = "absorption = { coefficient = ['0.05 + 0.2*exp(-r^2)', '0.1', '0.3*exp(-(x - 1)^2)'], emission = [0.1, 0, 0.02] }\n";
    let volume = "[[volumes]]\nabsorption = [\"0.05 + 0.2*exp(-r^2)\", \"0.1\", \"0.3*exp(-(x - 1)^2)\"]\nemission = [0.1, 0, 0.02]\n";
    let ball = "[materials.wall]\nkind = \"emissive\"\ncolor = [0.5, 1, 1]\n[[objects]]\nshape = \"sphere\"\nmaterial = \"wall\"\ncenter = [0, 0, -2]\n";
    for (law, rays, objects, bound) in [
        ("kind = \"straight\"", "", ball, 1e-4),
        ("kind = \"straight\"", "lighting = \"path-tracing\"", ball, 1e-4),
        ("kind = \"medium\"\nindex = { kind = \"luneburg\", c = 3, radius = 6 }", "", ball, 1e-4),
        (
            "kind = \"sources\"\nsources = [{ position = [0, 0.6, 0], strength = -0.2 }]",
            "method = \"dormand-prince\"\ntolerance = 1e-6",
            ball,
            1e-3,
        ),
        ("kind = \"schwarzschild\"\nmass = 0.2", "method = \"planar\"", ball, 1e-3),
        ("kind = \"kerr-newman\"\nmass = 0.2", "method = \"separated\"", "", 1e-3),
    ] {
        let with = |of_law: &str, others: &str| {
            let text = format!(
                "{VIEW}[law]\n{law}\n{of_law}[rays]\nbounding_sphere = {{ radius = 15 }}\n{rays}\n{objects}{others}"
            );
            rendered(&text, &[])
        };
        assert_close(&with(medium, ""), &with("", volume), bound, &format!("{law} {rays}"));
    }
}

/// Layers of a hundredth of a path, in media with formulas of the coefficient and of the transmittance, and with three colors.
#[test]
fn thin_layers_of_media_are_not_missed() {
    let width = 0.1;
    let layer = |height: f64| format!("{height}*exp(-((x - 0.37)/{width})^2)");
    let [first, second, third] = [1.0, 5.0, 12.0].map(layer);
    for (law, rays) in [
        ("kind = \"straight\"", ""),
        ("kind = \"schwarzschild\"\nmass = 1e-6", "method = \"planar\""),
        (
            "kind = \"sources\"\nsources = [{ position = [0, 3, 0], strength = -1e-6 }]",
            "method = \"dormand-prince\"\ntolerance = 1e-6",
        ),
    ] {
        for absorption in [
            format!("{{ coefficient = ['{first}', '{second}', '{third}'] }}"),
            format!("{{ transmittance = ['exp(-{first})', 'exp(-{second})', 'exp(-{third})'] }}"),
        ] {
            let text = format!(
                "[image]\nsize = [4, 4]\n[camera]\nposition = [10, 0.01, 0]\nup = [0, 0, 1]\nfov = 1\n[sky]\ncolor = [1, 1, 1]\n\
                 [law]\n{law}\nabsorption = {absorption}\n[rays]\nbounding_sphere = {{ radius = 10 }}\n{rays}\n"
            );
            let picture = rendered(&text, &[]);
            for (channel, height) in [1.0, 5.0, 12.0].into_iter().enumerate() {
                // Rays are inclined by at most half a degree, which makes paths longer by 4e-5.
                let expected = (-height * width * std::f64::consts::PI.sqrt()).exp();
                for found in &picture.band.color[channel] {
                    let off = (f64::from(*found) / expected).ln().abs();
                    assert!(off < 3e-3, "{law}, {absorption}, {channel}: {found} for {expected}");
                }
            }
        }
    }
}

/// A floor in the shadow of matter is as bright behind a box of glass without refraction as behind a volume, in straight light and by paths
/// from the lamp.
#[test]
fn volumes_cast_shadows() {
    for shadows in ["\"straight-rays\"\ntransparent = \"tinted\"", "\"photon-grid\"\npaths = 400000"] {
        let with = |block: &str| {
            let text = format!(
                "[image]\nsize = [12, 12]\n[camera]\nposition = [0, -6, 6]\nup = [0, 0, 1]\nfov = 30\n[rays]\nbounding_sphere = {{ radius = 15 }}\n\
                 [[lights]]\nkind = \"point\"\nposition = [0, 0, 8]\nshadows = {shadows}\ncolor = [40, 40, 40]\nfalloff = \"inverse-square\"\n\
                 [materials.floor]\nkind = \"phong\"\ndiffuse = [0.8, 0.8, 0.8]\n\
                 [[objects]]\nshape = \"box\"\nmaterial = \"floor\"\ncenter = [0, 0, -1]\nsize = [8, 8, 0.2]\n{block}"
            );
            rendered(&text, &[])
        };
        let place = "shape = \"box\"\ncenter = [0, 0, 5]\nsize = [0.9, 0.9, 1]\n";
        let absorption = "[\"0.7\", \"0.2 + x^2\", \"1.5\"]";
        let glass = with(&format!(
            "[[objects]]\n{place}interior = {{ kind = \"constant\", n = 1, absorption = {{ coefficient = {absorption} }} }}\n"
        ));
        let volume = with(&format!("[[volumes]]\n{place}absorption = {absorption}\n"));
        let clear = with("");
        // Paths to a grid are random.
        let bound = if shadows.contains("grid") { 0.03 } else { 1e-4 };
        for channel in 0..3 {
            let sum = |picture: &Rendering| picture.band.color[channel].iter().sum::<f32>();
            let [glass, volume, clear] = [&glass, &volume, &clear].map(sum);
            assert!(
                (volume / glass - 1.0).abs() < bound && volume < 0.97 * clear,
                "{shadows}: {volume} {glass} {clear}"
            );
        }
    }
}

/// The absorption of a medium weakens light of given frequencies by the mean of its colors, whatever stands between.
#[test]
fn media_absorb_light_of_frequencies() {
    let with = |absorption: &str| {
        let text = format!(
            "[image]\nsize = [1, 1]\n[camera]\nposition = [5, 0, 0]\nfov = 0.1\n[law]\nkind = \"straight\"\n{absorption}\
             [rays]\nbounding_sphere = {{ radius = 5.5 }}\n[radiation]\nfrequencies = [1.0, 2.0]\n\
             [[volumes]]\nshape = \"sphere\"\nradius = 0.01\nemission = 100\n"
        );
        rendered(&text, &[]).totals.radiation[0].brightest
    };
    let weakened = with("absorption = { coefficient = [0.1, 0.2, 0.3] }\n") / with("");
    assert!((weakened / (-1.0_f64).exp() - 1.0).abs() < 3e-3, "{weakened}");
}

/// One ball rests, and another comes nearer at v = 0.6: g is 1 and 2, and its mean is weighted by intensity.
#[test]
fn redshifts_are_means_by_intensity() {
    let ball = |center: f64, flow: &str| {
        format!(
            "[[volumes]]\nshape = \"sphere\"\ncenter = [{center}, 0, 0]\nemission = \"nu^-1\"\nabsorption = \"0.3*nu\"\n{flow}"
        )
    };
    let [still, near] = [ball(-3.0, ""), ball(3.0, "flow = { velocity = [\"0.6\", \"0\", \"0\"] }\n")];
    let layers = [Layer::Intensity(1), Layer::OpticalDepth(1), Layer::MeanRedshift(1), Layer::MeanRedshift(0)];
    let with = |volumes: &str, sky: f64| {
        let text = format!(
            "[image]\nsize = [1, 1]\n[camera]\nposition = [30, 0.2, 0]\nlook_at = [0, 0.2, 0]\nfov = 0.001\nobserver = \"static\"\n\
             [sky]\ncolor = [{sky}, {sky}, {sky}]\n[law]\nkind = \"straight\"\n[rays]\nbounding_sphere = {{ radius = 40 }}\n\
             [radiation]\nfrequencies = [1.0, 2.0]\ntolerance = 1e-5\n{volumes}"
        );
        let found = rendered(&text, &layers);
        layers.map(|layer| match found.band.layer(layer) {
            Some(Plane::Scalar(values)) => f64::from(values[0]),
            _ => panic!("{layer:?}"),
        })
    };
    let ([one, _, g, _], [two, depth, approaching, other]) = (with(&still, 0.0), with(&near, 0.0));
    assert!(
        (g - 1.0).abs() < 1e-5 && (approaching - 2.0).abs() < 1e-4 && (other - 2.0).abs() < 1e-4,
        "{g} {approaching}"
    );
    let [both, _, mean, _] = with(&format!("{still}{near}"), 0.0);
    let behind = (-depth).exp() * one;
    assert!((both / (two + behind) - 1.0).abs() < 1e-4, "{both} {two} {behind}");
    assert!((mean / ((2.0 * two + behind) / (two + behind)) - 1.0).abs() < 1e-4, "{mean}");
    // The light of the sky is not shifted for an observer at rest.
    let [all, _, mean, _] = with(&near, 0.5);
    assert!((mean - (2.0 * two + (all - two)) / all).abs() < 1e-4, "{mean} {all} {two}");
}
