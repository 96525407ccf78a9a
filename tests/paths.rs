//! Tests path tracing: furnaces, emitters against closed forms, and the same light with every kind of light sampling.

use bentray::program::{Layer, ProgramOptions, RaySkipping, Schedule};
use bentray::render::{Plane, RenderSettings, Renderer, Rendering, Status, Window};
use bentray::scene::{Override, Scene};

use crate::support::{assert_same_image, gpu, mean_of, scene, scenes_in};

/// Returns a closed ball that emits and reflects: its radiance is L = Le/(1 − albedo) in every direction, under any law.
fn furnace(law: &str, camera: &str, rest: &str) -> String {
    format!(
        "[image]\nsize = [24, 16]\nsamples = 4\n[camera]\nposition = {camera}\nlook_at = [3, 0.5, 0.2]\nfov = 70\n\
         [law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 4 }}\nlighting = \"path-tracing\"\n[path_tracing]\nrr_depth = 100000\nlight_sampling = false\n\
         [materials.wall]\nkind = \"phong\"\ndiffuse = [0.5, 0.2, 0]\nemission = [0.5, 0.4, 0.3]\n\
         [[objects]]\nshape = \"sphere\"\nradius = 2\nmaterial = \"wall\"\n{rest}"
    )
}

pub fn rendered(scene: &Scene, settings: RenderSettings) -> Rendering {
    Renderer::new(&gpu(), scene, settings).unwrap().render().unwrap()
}

/// The radiance of a floor under an emitter is its albedo times E/π, with and without light sampling.
#[test]
fn lamps_light_as_closed_forms_say() {
    let emitters = [
        ("shape = \"sphere\"\ncenter = [0, 4, 0]\nradius = 1", 0.0625),
        ("shape = \"sphere\"\ncenter = [3, 4, 1]\nradius = 1.5", 0.067_886_354_470_909_86),
        ("shape = \"sphere\"\ncenter = [5, 0.5, 0]\nradius = 2", 0.023_106_085_830_083_965),
        ("shape = \"disk\"\nscale = 1\ntranslate = [0, 2, 0]", 0.2),
        ("shape = \"box\"\ncenter = [0, 1.98, 0]\nsize = [0.5, 1e-6, 0.5]", 0.019_876_246_392_363_97),
    ];
    for (lamp, form_factor) in emitters {
        for aim in [true, false] {
            let text = format!(
                "[image]\nsize = [16, 16]\nsamples = 64\n[camera]\nkind = \"orthographic\"\nheight = 1e-4\nposition = [0, 0.02, 0]\n\
                 look_at = [0, 0, 0]\nup = [0, 0, 1]\n[rays]\nbounding_sphere = {{ radius = 30 }}\nlighting = \"path-tracing\"\n\
                 [path_tracing]\nlight_sampling = {aim}\n[materials.floor]\nkind = \"phong\"\ndiffuse = [1, 0.5, 0]\n\
                 [materials.lamp]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n[[objects]]\nshape = \"box\"\nmaterial = \"floor\"\n\
                 center = [0, -1, 0]\nsize = [24, 2, 24]\n[[objects]]\nmaterial = \"lamp\"\n{lamp}\n"
            );
            let picture = rendered(&scene(&text), RenderSettings::default());
            let (mean, error) = mean_of(&picture, 0);
            // Four standard errors, and the effect of the camera's distance and of rounding.
            assert!((mean - form_factor).abs() < 4.0 * error + 3e-5 * form_factor, "{lamp}, {aim}: {mean} ± {error}");
            assert!(error < 0.04 * form_factor, "{lamp}: {error}");
            assert!(picture.band.color[2].iter().all(|x| *x == 0.0));
        }
    }
}

/// Returns a box with two emitters, a mirror and glass under a law.
fn room(law: &str, aims: [bool; 2], aim: bool) -> String {
    format!(
        "[image]\nsize = [16, 16]\nsamples = 256\n[camera]\nposition = [0, 0.2, 2.6]\nfov = 50\n[law]\n{law}\n\
         [rays]\nbounding_sphere = {{ radius = 8 }}\nlighting = \"path-tracing\"\n[path_tracing]\nlight_sampling = {aim}\n\
         [sky]\ncolor = [0.1, 0.2, 0.3]\n\
         [materials.wall]\nkind = \"phong\"\ndiffuse = [0.7, 0.6, 0.5]\n\
         [materials.shiny]\nkind = \"phong\"\ndiffuse = [0.3, 0.3, 0.3]\nspecular = [0.5, 0.5, 0.5]\nshininess = 12\n\
         [materials.mirror]\nkind = \"mirror\"\ncolor = [0.9, 0.9, 0.9]\n\
         [materials.a]\nkind = \"emissive\"\ncolor = [6, 6, 5]\nlight_sampling = {}\n[materials.b]\nkind = \"emissive\"\ncolor = [5, 7, 9]\nlight_sampling = {}\n\
         [[objects]]\nshape = \"box\"\nmaterial = \"wall\"\ncenter = [0, -1.5, 0]\nsize = [6, 1, 6]\n\
         [[objects]]\nshape = \"box\"\nmaterial = \"shiny\"\ncenter = [0, 0, -2]\nsize = [6, 3, 0.5]\n\
         [[objects]]\nshape = \"sphere\"\nmaterial = \"mirror\"\ncenter = [-0.7, -0.5, 0]\nradius = 0.4\n\
         [[objects]]\nshape = \"sphere\"\nmaterial = \"a\"\ncenter = [1.2, 0.8, 0.3]\nradius = 0.5\n\
         [[objects]]\nshape = \"box\"\nmaterial = \"b\"\ncenter = [-1.2, 0.9, -0.5]\nsize = [0.6, 0.6, 0.6]\n",
        aims[0], aims[1]
    )
}

/// Light sampling changes only the noise, however strongly the law bends the rays.
#[test]
fn aims_do_not_change_the_light() {
    let force =
        "kind = \"sources\"\n[[law.sources]]\nposition = [0, 0.2, 0]\nstrength = 0.5\nfalloff = { cubic = 0.4 }";
    for law in ["kind = \"straight\"", force] {
        let pictures = [([true, true], true), ([true, true], false), ([true, false], true)].map(|(aims, aim)| {
            let picture = rendered(&scene(&room(law, aims, aim)), RenderSettings::default());
            assert_eq!(picture.totals.unfollowed(), 0, "{}", picture.totals);
            let noise = picture.totals.noise.clone().unwrap().mean().unwrap();
            let light =
                picture.band.color[1].iter().map(|x| f64::from(*x)).sum::<f64>() / picture.band.color[1].len() as f64;
            // The mean of all pixels has the error of one pixel divided by the root of their number.
            (light, noise * light / (picture.band.color[1].len() as f64).sqrt(), noise)
        });
        let [(light, error, noise), others @ ..] = pictures;
        for (other, own, _) in others {
            assert!((light - other).abs() < 4.0 * error.hypot(own), "{law}: {light} ± {error}, {other} ± {own}");
        }
        assert!(noise < 0.75 * others[0].2, "{law}: {noise} and {}", others[0].2);
    }
}

/// Checks the caustic below a glass ball, and that of an emitter behind a ball whose index decreases from its center.
#[test]
fn a_guide_changes_the_noise_and_not_the_light() {
    let ball = "[[objects]]\nshape = \"sphere\"\ncenter = [0, 1.2, 0]\nradius = 0.6\ninterior = 1.5\n";
    let bent =
        "kind = \"sources\"\n[[law.sources]]\nposition = [0, 1.2, 0]\nstrength = -0.4\nfalloff = { cubic = 0.4 }";
    for (law, rest) in [("kind = \"straight\"", ball), (bent, "")] {
        let [(on, on_error), (off, off_error)] = [true, false].map(|guide| {
            let text = format!(
                "[image]\nsize = [24, 24]\nsamples = 256\n[camera]\nkind = \"orthographic\"\nheight = 0.4\nposition = [0, 0.1, 0]\n\
                 look_at = [0, 0, 0]\nup = [0, 0, 1]\n[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 9 }}\n\
                 lighting = \"path-tracing\"\n[path_tracing]\nguiding = {guide}\n[materials.floor]\nkind = \"phong\"\n\
                 diffuse = [0.8, 0.8, 0.8]\n[materials.lamp]\nkind = \"emissive\"\ncolor = [40, 40, 40]\n\
                 [[objects]]\nshape = \"box\"\nmaterial = \"floor\"\ncenter = [0, -0.5, 0]\nsize = [5, 1, 5]\n\
                 [[objects]]\nshape = \"sphere\"\nmaterial = \"lamp\"\ncenter = [0, 5, 0]\nradius = 0.12\n{rest}"
            );
            let picture = rendered(&scene(&text), RenderSettings::default());
            assert_eq!(picture.totals.unfollowed(), 0, "{law}: {}", picture.totals);
            let error = picture.totals.noise.clone().unwrap().mean().unwrap();
            (mean_of(&picture, 1), error)
        });
        let apart = (on.0 - off.0).abs() / on.1.hypot(off.1);
        assert!(apart < 4.0, "{law}: {on:?} and {off:?}");
        assert!(on_error < 0.6 * off_error, "{law}: {on_error} and {off_error}");
    }
}

/// The result does not depend on the cuts of paths into passes, nor on the location of neighboring pixels.
#[test]
fn every_schedule_gives_the_same_bits() {
    let mut scene = scene(&room("kind = \"straight\"", [true, true], true).replace("samples = 256", "samples = 3"));
    scene.rays.max_segments = 120;
    for aim in [true, false] {
        if let Some(paths) = &mut scene.rays.path_tracing {
            paths.light_sampling = aim;
        }
        let layers = vec![Layer::StandardError, Layer::Normal];
        let of =
            |schedule, masks| ProgramOptions { schedule, masks, layers: layers.clone(), ..ProgramOptions::default() };
        let usual = rendered(
            &scene,
            RenderSettings { options: of(Schedule::Whole, RaySkipping::List), ..RenderSettings::default() },
        );
        for schedule in Schedule::ALL {
            for masks in [RaySkipping::List, RaySkipping::Grid, RaySkipping::Off] {
                let settings = RenderSettings { options: of(schedule, masks), ..RenderSettings::default() };
                assert_same_image(&rendered(&scene, settings), &usual, &format_args!("{schedule:?} {masks:?}"));
            }
        }
        let window = Window { origin: [5, 7], size: [8, 7] };
        let settings = RenderSettings {
            options: of(Schedule::Whole, RaySkipping::List),
            window: Some(window),
            memory: 1 << 20,
            ..RenderSettings::default()
        };
        let crop = rendered(&scene, settings);
        for y in 0..7 {
            let at = (7 + y) * 16 + 5;
            assert_eq!(crop.band.color[0][y * 8..y * 8 + 8], usual.band.color[0][at..at + 8]);
        }
    }
}

/// A limit on scattering events leaves a partial geometric sum, and the rest is counted.
#[test]
fn depth_cuts_paths() {
    let mut scene = scene(&furnace("kind = \"straight\"", "[0.3, 0.1, 0]", ""));
    let Some(paths) = &mut scene.rays.path_tracing else { panic!() };
    paths.max_depth = Some(3);
    let picture = rendered(&scene, RenderSettings::default());
    let expected = 0.5 * (1.0 + 0.5 + 0.25 + 0.125);
    assert!(picture.band.color[0].iter().all(|x| (x - expected).abs() < 1e-6));
    assert_eq!(picture.totals.count(Status::Cut), picture.totals.rays);
}

/// Glass does not emit: in front of a uniform sky it is invisible.
#[test]
fn glass_under_an_even_sky_vanishes() {
    for interior in ["1.5", "{ kind = \"luneburg\", c = 2 }", "{ kind = \"constant\", n = 2.4 }"] {
        let text = format!(
            "[image]\nsize = [16, 16]\nsamples = 4\n[camera]\nposition = [0, 0, 4]\nfov = 40\n[sky]\ncolor = [1, 0.5, 0.25]\n\
             [rays]\nbounding_sphere = {{ radius = 9 }}\nlighting = \"path-tracing\"\n[[objects]]\nshape = \"sphere\"\ninterior = {interior}\n"
        );
        let picture = rendered(&scene(&text), RenderSettings::default());
        for (channel, expected) in [1.0, 0.5, 0.25].into_iter().enumerate() {
            let off = picture.band.color[channel].iter().filter(|x| (**x - expected).abs() > 2e-6).count();
            assert_eq!(off, 0, "{interior}: {:?}", picture.totals);
        }
    }
}

/// The reported noise is the actual noise: the difference from an image with other random numbers.
#[test]
fn the_error_is_what_seeds_differ_by() {
    let text = room("kind = \"straight\"", [true, true], true)
        .replace("samples = 256", "samples = 64")
        .replace("[16, 16]", "[24, 24]");
    let of = |seed: &str| {
        let change: Override = format!("path_tracing.seed={seed}").parse().unwrap();
        let scene = Scene::parse(&text, std::path::Path::new("test.toml"), &[change]).unwrap();
        let options = ProgramOptions { layers: vec![Layer::StandardError], ..ProgramOptions::default() };
        rendered(&scene, RenderSettings { options, ..RenderSettings::default() })
    };
    let [a, b] = ["1", "2"].map(of);
    let Some(Plane::Scalar(errors)) = a.band.layer(Layer::StandardError) else { panic!("no errors") };
    let squares = |values: &[f32]| values.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>();
    let light = |band: &bentray::render::Band, i: usize| {
        0.2126 * band.color[0][i] + 0.7152 * band.color[1][i] + 0.0722 * band.color[2][i]
    };
    let apart: Vec<f32> = (0..errors.len()).map(|i| light(&a.band, i) - light(&b.band, i)).collect();
    // Stratified samples have smaller errors than independent ones, for smooth light by an order of magnitude.
    let share = squares(&apart) / (2.0 * squares(errors));
    assert!((0.03..1.3).contains(&share), "{share}");
}

/// The edge of a bright ball has no other noise than that of the sample positions.
#[test]
fn seeds_change_the_sample_positions() {
    let text = "[image]\nsize = [48, 48]\nsamples = 4\n[camera]\nposition = [0, 0, 4]\nfov = 40\n\
                [rays]\nbounding_sphere = { radius = 9 }\nlighting = \"path-tracing\"\n\
                [materials.lamp]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n[[objects]]\nshape = \"sphere\"\nmaterial = \"lamp\"\n";
    let of = |sampler: &str, seed: u32| {
        let changes = [format!("path_tracing.seed={seed}"), format!("image.sampler={sampler}")];
        let changes = changes.map(|change| change.parse().unwrap());
        let scene = Scene::parse(text, std::path::Path::new("test.toml"), &changes).unwrap();
        rendered(&scene, RenderSettings::default()).band.color[0].clone()
    };
    for sampler in ["sobol", "multi-jittered"] {
        let images = [0, 1, 2].map(|seed| of(sampler, seed));
        for (a, b) in [(0, 1), (0, 2), (1, 2)] {
            let other = images[a].iter().zip(&images[b]).filter(|(a, b)| a.to_bits() != b.to_bits()).count();
            assert!(other > 10, "{sampler}: seeds {a} and {b} differ in {other} pixels");
        }
    }
}

#[test]
fn shipped_scenes_render() {
    let all = scenes_in("scenes/paths");
    assert!(!all.is_empty());
    for path in all {
        let small = ["image.size=[32, 32]", "image.samples=4"].map(|change| change.parse().unwrap());
        let scene = Scene::load(&path, &small).unwrap_or_else(|error| panic!("{error}"));
        let picture = rendered(&scene, RenderSettings::default());
        assert_eq!(picture.totals.unfollowed(), 0, "{}: {}", path.display(), picture.totals);
    }
}

/// The light that clamping removes is missing from the image; all schedules and tiles agree on it.
#[test]
fn what_clamped_samples_lose_is_counted() {
    let mut scene = scene(&room("kind = \"straight\"", [true, true], true).replace("samples = 256", "samples = 16"));
    let whole = rendered(&scene, RenderSettings::default());
    scene.output.clamp = Some(0.7);
    let light = |picture: &Rendering| (0..3).map(|channel| mean_of(picture, channel).0).sum::<f64>() / 3.0;
    let pixels = f64::from(scene.image.size[0] * scene.image.size[1] * scene.image.samples);
    let mut first = None;
    for (schedule, tile_pixels) in [(Schedule::Whole, 1 << 20), (Schedule::Fused, 100)] {
        let options = ProgramOptions { schedule, ..ProgramOptions::default() };
        let picture = rendered(&scene, RenderSettings { options, tile_pixels, ..RenderSettings::default() });
        let clamped = picture.totals.clamped.unwrap();
        let lacks = pixels * (light(&whole) - light(&picture));
        assert!(clamped.samples > 100 && clamped.lost > 0.0, "{clamped}");
        assert!((clamped.lost - lacks).abs() < 1e-4 * clamped.lost, "{} and {lacks}", clamped.lost);
        assert!((clamped.left - pixels * light(&picture)).abs() < 1e-5 * clamped.left, "{clamped:?}");
        let (band, samples) = first.get_or_insert((picture.band.clone(), clamped.samples));
        assert!(*band == picture.band && *samples == clamped.samples);
    }
}
