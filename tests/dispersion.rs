//! Media whose index depends on the wavelength: prisms against the law of minimum deviation, and white light stays white.

use bentray::model::medium::VISIBLE;
use bentray::program::constant;
use bentray::render::{RenderSettings, Renderer, trace};
use glam::{DVec3, Vec4};

use crate::support::{gpu, mean_of, probe::Probe, scene};

/// Returns the index of SF11 at a wavelength in nanometers.
fn heavy_flint(nm: f64) -> f64 {
    let square = (nm / 1000.0).powi(2);
    let terms = [(1.737_596_95, 0.013_188_707), (0.313_747_346, 0.062_306_814_2), (1.898_781_01, 155.236_29)];
    (1.0 + terms.iter().map(|(b, c)| b * square / (square - c)).sum::<f64>()).sqrt()
}

/// Paths sample the wavelengths that a scene may specify.
#[test]
fn visible_light_is_the_same_everywhere() {
    let drawn = ["SHORTEST", "LONGEST"].map(|name| constant("path/spectrum", name).to_bits());
    assert_eq!(drawn, [VISIBLE.start(), VISIBLE.end()].map(|end| end.to_bits()));
}

/// A prism of angle A deflects a symmetric ray by D, where n = sin((A + D)/2)/sin(A/2).
#[test]
fn prisms_turn_each_wavelength_by_its_least_deviation() {
    let folder = tempfile::tempdir().unwrap();
    // An angle of 60°, along z, with the edge at the top.
    let corners = [[-1.0, 0.0], [1.0, 0.0], [0.0, 3.0_f64.sqrt()]];
    let vertices = [-1, 1].into_iter().flat_map(|z| corners.map(|[x, y]| format!("v {x} {y} {z}\n")));
    let mut obj: String = vertices.collect();
    obj += "f 1 3 2\nf 4 5 6\nf 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\nf 3 1 4\nf 3 4 6\n";
    std::fs::write(folder.path().join("prism.obj"), obj).unwrap();
    let file = folder.path().join("prism.obj");
    for (precision, allowed) in [("f32", 3e-6), ("f64", 2e-7)] {
        for nm in [404.66, 486.13, 587.56, 656.27] {
            let deviation = 2.0 * (heavy_flint(nm) * 0.5).asin() - 60.0_f64.to_radians();
            // Inside, the ray is parallel to the base and goes through the centers of both faces.
            let (sin, cos) = (deviation / 2.0).sin_cos();
            let (along, face) = (DVec3::new(cos, sin, 0.0), DVec3::new(-0.5, 0.75_f64.sqrt(), 0.0));
            let start = face - 3.0 * along;
            let text = format!(
                "[rays]\nbounding_sphere = {{ radius = 8 }}\nwavelength = {nm}\nprecision = \"{precision}\"\n\
                 [[objects]]\nshape = \"mesh\"\nfile = {file:?}\ninterior = {{ kind = \"sellmeier\", glass = \"SF11\" }}\n"
            );
            let ray = [start.x, start.y, start.z, along.x, along.y, along.z];
            let (ends, _) = trace(&gpu(), &scene(&text), &RenderSettings::default(), &[ray]).unwrap();
            let way = DVec3::from_array(ends[0].v).normalize();
            let off = (way - DVec3::new(cos, -sin, 0.0)).length();
            assert!(off < allowed, "{nm} nm in {precision}: off by {off}");
        }
    }
}

/// All wavelengths add up to white, and none reduces another.
#[test]
fn colours_of_the_spectrum_add_up_to_white() {
    const COUNT: usize = 7000;
    let inputs: Vec<[Vec4; 1]> =
        (0..COUNT).map(|k| [Vec4::splat(380.0 + 350.0 * (k as f32 + 0.5) / COUNT as f32)]).collect();
    let parts = ["path/spectrum", "path/carried", "surface/region_none", "medium/vacuum"];
    let colors = Probe::new(&parts).run::<1, 1>(&gpu(), "put(0u, vec4f(spectral_color(p0.x), 0.0));", &inputs);
    let colors: Vec<DVec3> = colors.iter().map(|[color]| color.truncate().as_dvec3()).collect();
    let mean = colors.iter().sum::<DVec3>() / COUNT as f64;
    assert!((mean - 1.0).abs().max_element() < 2e-5, "{mean}");
    assert!(colors.iter().all(|color| color.min_element() >= 0.0));
    let at = |nm: f64| colors[((nm - 380.0) / 350.0 * COUNT as f64) as usize];
    let strongest = |color: DVec3| (0..3).max_by(|a, b| color[*a].total_cmp(&color[*b])).unwrap();
    assert_eq!([450.0, 530.0, 620.0].map(|nm| strongest(at(nm))), [2, 1, 0]);
}

/// Returns the mean of each channel over an image, with its standard error.
fn means(text: &str) -> [(f64, f64); 3] {
    let picture = Renderer::new(&gpu(), &scene(text), RenderSettings::default()).unwrap().render().unwrap();
    assert_eq!(picture.totals.unfollowed(), 0, "{}", picture.totals);
    [0, 1, 2].map(|channel| mean_of(&picture, channel))
}

fn ball(interior: &str, sky: &str, rest: &str) -> String {
    format!(
        "[image]\nsize = [40, 40]\nsamples = 256\n[camera]\nposition = [0, 0, 4]\nfov = 28\n[sky]\ncolor = {sky}\n\
         [rays]\nbounding_sphere = {{ radius = 6 }}\nlighting = \"path-tracing\"\n\
         [[objects]]\nshape = \"sphere\"\ninterior = {interior}\n{rest}"
    )
}

/// Glass under a uniform sky is invisible in every channel, whatever its dispersion.
#[test]
fn glass_under_a_white_sky_stays_white() {
    for glass in ["SF11", "diamond"] {
        let interior = format!("{{ kind = \"sellmeier\", glass = \"{glass}\" }}");
        for (channel, (mean, error)) in means(&ball(&interior, "[1, 1, 1]", "")).into_iter().enumerate() {
            assert!(
                error > 0.0 && error < 2e-3 && (mean - 1.0).abs() < 4.0 * error,
                "{glass}, {channel}: {mean} ± {error}"
            );
        }
    }
}

/// Glass with one index at all wavelengths gives the light of nondispersive glass, with the same caustics.
#[test]
fn glass_without_dispersion_is_plain_glass() {
    let rest = "[materials.floor]\nkind = \"phong\"\ndiffuse = [0.8, 0.5, 0.3]\n[materials.lamp]\nkind = \"emissive\"\n\
                color = [30, 30, 30]\n[[objects]]\nshape = \"box\"\nmaterial = \"floor\"\ncenter = [0, -1.3, 0]\nsize = [5, 0.2, 5]\n\
                [[objects]]\nshape = \"sphere\"\nmaterial = \"lamp\"\ncenter = [0.5, 3, 0]\nradius = 0.3\n";
    let plain = means(&ball("1.5", "[0.1, 0.1, 0.1]", rest));
    let spectral = means(&ball("{ kind = \"sellmeier\", b = [1.25], c = [0] }", "[0.1, 0.1, 0.1]", rest));
    for (plain, spectral) in plain.iter().zip(spectral) {
        let apart = (plain.0 - spectral.0).abs() / plain.1.hypot(spectral.1);
        assert!(apart < 4.0 && plain.1 < 0.1 * plain.0, "{plain:?}, {spectral:?}");
    }
}
