//! Tests the lobes around the mirror direction and the refracted direction against integrals.

use std::f64::consts::PI;

use bentray::glam::{DVec3, dvec3};
use bentray::program::{ProgramOptions, RaySkipping, Schedule};
use bentray::render::{RenderSettings, Renderer, Rendering, Status};

use crate::support::{assert_same_image, gpu, mean_of, scene};

fn rendered(text: &str, options: ProgramOptions) -> Rendering {
    Renderer::new(&gpu(), &scene(text), RenderSettings { options, ..RenderSettings::default() })
        .unwrap()
        .render()
        .unwrap()
}

/// The exponent, the angle from the normal in degrees, the fraction of a lobe above the surface, and the albedo of the reciprocal form.
const LOBES: [[f64; 4]; 6] = [
    [0.0, 60.0, 0.666_666_7, 0.75],
    [1.0, 45.0, 0.853_553_4, 0.755_409_2],
    [1.0, 85.0, 0.543_577_9, 0.363_096_9],
    [10.0, 80.0, 0.714_762_3, 0.228_056_1],
    [100.0, 75.0, 0.995_852_2, 0.258_944_6],
    [1000.0, 85.0, 0.997_128_0, 0.087_183_0],
];

/// Returns a scene with a disk under a uniform sky, seen at an angle.
fn disk(material: &str, transport: &str, degrees: f64) -> String {
    let (sin, cos) = degrees.to_radians().sin_cos();
    format!(
        "[image]\nsize = [16, 16]\nsamples = 64\n[camera]\nkind = \"orthographic\"\nheight = 0.001\nposition = [{}, {}, 0]\n\
         up = [0, 0, 1]\n[sky]\ncolor = [1, 1, 1]\n[rays]\nbounding_sphere = {{ radius = 20 }}\nlighting = \"{transport}\"\n\
         [materials.m]\n{material}\n[[objects]]\nshape = \"disk\"\nmaterial = \"m\"\nradius = 2\n",
        5.0 * sin,
        5.0 * cos
    )
}

#[test]
fn lobes_keep_what_lies_above_the_surface() {
    for [exponent, degrees, kept, albedo] in LOBES {
        let glossy = format!("kind = \"glossy\"\nexponent = {exponent}");
        let phong =
            format!("kind = \"phong\"\ndiffuse = [0, 0, 0]\nspecular = [1, 1, 1]\nshininess = {}", exponent.max(1e-6));
        for (material, transport, expected) in
            [(&glossy, "direct", kept), (&glossy, "path-tracing", kept), (&phong, "path-tracing", albedo)]
        {
            let picture = rendered(&disk(material, transport, degrees), ProgramOptions::default());
            let (mean, error) = mean_of(&picture, 0);
            let z = (mean - expected) / error.max(3e-5 * expected);
            assert!(
                z.abs() < 4.0 && error < 0.01 * expected,
                "{material}, {transport}, {degrees}: {mean} ± {error}, {expected}"
            );
        }
    }
}

const BALL: &str = "[image]\nsize = [32, 32]\nsamples = 16\n[camera]\nposition = [0, 0, 4]\nfov = 40\n[rays]\nbounding_sphere = { radius = 9 }\n\
    [materials.wall]\nkind = \"emissive\"\ncolor = { checker = [[1, 1, 1], [0.2, 0.4, 0.6]] }\n\
    [[objects]]\nshape = \"box\"\nmaterial = \"wall\"\ncenter = [0, 0, -3]\nsize = [9, 9, 1]\n\
    [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"constant\", n = 1.5, GLOSS }\n";

/// A sufficiently narrow lobe acts as the smooth surface.
#[test]
fn narrow_lobes_are_smooth() {
    let smooth = rendered(&BALL.replace(", GLOSS", ""), ProgramOptions::default());
    let narrow =
        rendered(&BALL.replace("GLOSS", "reflect_exponent = 1e9, transmit_exponent = 1e9"), ProgramOptions::default());
    let rough = rendered(&BALL.replace("GLOSS", "transmit_exponent = 30"), ProgramOptions::default());
    let apart = |other: &Rendering| {
        let off = smooth.band.color[0].iter().zip(&other.band.color[0]).map(|(a, b)| f64::from((a - b).abs()));
        off.sum::<f64>() / smooth.band.color[0].len() as f64
    };
    let flat = rendered(&BALL.replace("GLOSS", "roughness = 1e-4"), ProgramOptions::default());
    assert!(apart(&narrow) < 2e-3, "{}", apart(&narrow));
    assert!(apart(&flat) < 2e-3, "{}", apart(&flat));
    assert!(apart(&rough) > 0.05, "{}", apart(&rough));
}

/// Returns the reflected and transmitted fractions of a microfacet surface between air and a medium of index n at an angle,
/// by sums over the outgoing directions (Walter et al. 2007, Eqs. 20, 21, 33 and 34; Smith's G).
#[allow(clippy::many_single_char_names, reason = "the letters of the paper")]
fn microfacet_albedos(a: f64, n: f64, degrees: f64) -> [f64; 2] {
    const STEPS: usize = 600;
    let (sin, cos) = degrees.to_radians().sin_cos();
    let i = dvec3(sin, 0.0, cos);
    let spread = |c: f64| if c > 0.0 { (a / (c * c * (a * a - 1.0) + 1.0)).powi(2) / PI } else { 0.0 };
    let open = |v: DVec3, m: DVec3| {
        let tan2 = (1.0 - v.z * v.z) / (v.z * v.z);
        if v.dot(m) * v.z > 0.0 { 2.0 / (1.0 + (1.0 + a * a * tan2).sqrt()) } else { 0.0 }
    };
    let fresnel = |c: f64| {
        let g = (n * n - 1.0 + c * c).sqrt();
        let (x, y) = ((g - c) / (g + c), (c * (g + c) - 1.0) / (c * (g - c) + 1.0));
        0.5 * x * x * (1.0 + y * y)
    };
    let mut sums = [0.0; 2];
    let cell = 2.0 * PI / STEPS as f64 / STEPS as f64;
    for (j, k) in (0..STEPS).flat_map(|j| (0..STEPS).map(move |k| (j, k))) {
        // Steps are finer near the normal, where lobes are narrow.
        let u = (j as f64 + 0.5) / STEPS as f64;
        let (z, cell) = (1.0 - u * u, cell * 2.0 * u);
        let (s, phi) = ((1.0 - z * z).sqrt(), PI * (2.0 * k as f64 + 1.0) / STEPS as f64);
        let o = dvec3(s * phi.cos(), s * phi.sin(), z);
        let m = (i + o).normalize();
        sums[0] += cell * fresnel(i.dot(m)) * spread(m.z) * open(i, m) * open(o, m) / (4.0 * i.z);
        let o = dvec3(o.x, o.y, -o.z);
        let m = -(i + n * o).normalize();
        let (im, om) = (i.dot(m), o.dot(m));
        if im > 0.0 && om < 0.0 {
            let lens = n * n / (im + n * om).powi(2);
            sums[1] +=
                cell * (im * om).abs() / i.z * lens * (1.0 - fresnel(im)) * open(i, m) * open(o, m) * spread(m.z);
        }
    }
    sums
}

/// Checks a thick plate under a red sky, with green light inside.
#[test]
fn microfacets_reflect_and_transmit_by_their_distribution() {
    for (a, n, degrees) in [(0.3, 1.5, 0.0), (0.3, 1.5, 60.0), (0.6, 1.5, 45.0), (0.5, 1.3, 75.0), (1.0, 2.4, 30.0)] {
        let expected = microfacet_albedos(a, n, degrees);
        let (sin, cos) = f64::to_radians(degrees).sin_cos();
        for transport in ["max_splits = \"stochastic\"", "lighting = \"path-tracing\"", "max_splits = 1"] {
            let text = format!(
                "[image]\nsize = [16, 16]\nsamples = 256\n[camera]\nkind = \"orthographic\"\nheight = 0.001\nposition = [{}, {}, 0]\n\
                 up = [0, 0, 1]\n[sky]\ncolor = [1, 0, 0]\n[rays]\nbounding_sphere = {{ radius = 3000 }}\n{transport}\n\
                 [materials.lamp]\nkind = \"emissive\"\ncolor = [0, {}, 0]\n\
                 [[objects]]\nshape = \"box\"\ncenter = [0, -1, 0]\nsize = [1000, 2, 1000]\ninterior = {{ kind = \"constant\", n = {n}, roughness = {a} }}\n\
                 [[objects]]\nshape = \"box\"\nmaterial = \"lamp\"\ncenter = [0, -1, 0]\nsize = [999.9, 1.99, 999.9]\n",
                5.0 * sin,
                5.0 * cos,
                n * n
            );
            let picture = rendered(&text, ProgramOptions::default());
            for (channel, expected) in expected.into_iter().enumerate() {
                let (mean, error) = mean_of(&picture, channel);
                let z = (mean - expected) / error.max(1e-4 * expected);
                assert!(
                    z.abs() < 4.0 && error < 0.03 * expected,
                    "a = {a}, n = {n}, {degrees}°, {transport}, {channel}: {mean} ± {error}, {expected}"
                );
            }
        }
    }
}

/// Light that would end on the wrong side is lost and counted.
#[test]
fn lost_light_is_counted() {
    let rough = BALL.replace("GLOSS", "reflect_exponent = 2, transmit_exponent = 2");
    let text = rough.replace("[rays]", "[rays]\nmax_splits = \"stochastic\"");
    let picture = rendered(&text, ProgramOptions::default());
    assert!(picture.totals.count(Status::Cut) > 0, "{}", picture.totals);
    assert_eq!(picture.totals.unfollowed(), 0, "{}", picture.totals);
}

#[test]
fn every_schedule_draws_the_same_lobes() {
    let text =
        BALL.replace("GLOSS", "reflect_exponent = 50, transmit_exponent = 30").replace("samples = 16", "samples = 2");
    let text = text.replace("[rays]", "[rays]\nmax_segments = 60");
    let usual = rendered(&text, ProgramOptions::default());
    for schedule in Schedule::ALL {
        let other = rendered(&text, ProgramOptions { schedule, masks: RaySkipping::Off, ..ProgramOptions::default() });
        assert_same_image(&other, &usual, &format_args!("{schedule:?}"));
    }
}
