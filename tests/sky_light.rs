//! Tests the light of the environment map in path tracing: the sampled fraction, and the total compared with sums over the image.

use std::f64::consts::PI;
use std::path::Path;

use bentray::render::RenderSettings;

use crate::paths::rendered;
use crate::support::{mean_of, scene};

/// Writes a sky with a small sun: `size` pixels of one sRGB value, except for one white pixel.
fn sun(folder: &Path, name: &str, size: [u32; 2], place: [u32; 2], even: u8) {
    let at = |x, y| image::Luma([if [x, y] == place { 255 } else { even }]);
    image::GrayImage::from_fn(size[0], size[1], at).save(folder.join(name)).unwrap();
}

/// Compares the radiance of a floor with sums over the sky: for an equirectangular image, and for the center of a cube map's top.
#[test]
fn the_sky_lights_as_sums_over_it_say() {
    const EVEN: u8 = 30;
    let folder = tempfile::tempdir().unwrap();
    sun(folder.path(), "globe.png", [64, 32], [20, 9], EVEN);
    sun(folder.path(), "top.png", [16, 16], [5, 8], EVEN);
    sun(folder.path(), "side.png", [16, 16], [99, 0], EVEN);
    let even = ((f64::from(EVEN) / 255.0 + 0.055) / 1.055).powf(2.4);
    // The filter of a pixel is a tent between its center and those of its neighbors.
    let tent = |x: f64| (1.0 - x.abs()).max(0.0);
    let (steps, sun) = (400, 1.0 - even);
    let around_pixel = || {
        (0..steps * steps).map(|k| [k % steps, k / steps].map(|k| 2.0 * (f64::from(k) + 0.5) / f64::from(steps) - 1.0))
    };
    let of_pixel = |f: &dyn Fn(f64, f64) -> f64| {
        around_pixel().map(|[x, y]| tent(x) * tent(y) * f(x, y)).sum::<f64>() * 4.0 / f64::from(steps * steps)
    };
    let globe = of_pixel(&|_, y| {
        let polar = PI * (9.5 + y) / 32.0;
        polar.cos() * polar.sin() * (2.0 * PI / 64.0) * (PI / 32.0)
    });
    let cube = of_pixel(&|x, y| {
        let [x, y] = [(5.5 + x) / 8.0 - 1.0, (8.5 + y) / 8.0 - 1.0];
        1.0 / (1.0 + x * x + y * y).powi(2) / 64.0
    });
    let path = |name: &str| format!("{:?}", folder.path().join(name));
    let faces = ["side", "side", "top", "side", "side", "side"].map(|face| path(&format!("{face}.png"))).join(", ");
    for (sky, of_sun) in [(format!("image = {}", path("globe.png")), globe), (format!("faces = [{faces}]"), cube)] {
        let exact = 50.0 * (even + sun * of_sun / PI);
        let errors = [true, false].map(|aim| {
            let text = format!(
                "[image]\nsize = [16, 16]\nsamples = 256\n[camera]\nkind = \"orthographic\"\nheight = 1e-4\nposition = [0, 0.02, 0]\n\
                 look_at = [0, 0, 0]\nup = [0, 0, 1]\n[rays]\nbounding_sphere = {{ radius = 30 }}\nlighting = \"path-tracing\"\n\
                 [sky]\n{sky}\nintensity = 50\n[path_tracing]\nlight_sampling = {aim}\n[materials.floor]\nkind = \"phong\"\n\
                 diffuse = [1, 1, 1]\n[[objects]]\nshape = \"disk\"\nmaterial = \"floor\"\nscale = 24\n"
            );
            let (mean, error) = mean_of(&rendered(&scene(&text), RenderSettings::default()), 0);
            assert!((mean - exact).abs() < 4.0 * error + 3e-5 * exact, "{sky}, {aim}: {mean} ± {error}, not {exact}");
            error
        });
        assert!(errors[0] < 0.3 * errors[1], "{sky}: {errors:?}");
    }
}

/// A uniform sky has no light sampling, which would only cost time.
#[test]
fn only_what_is_bright_in_the_sky_is_aimed_at() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sky.png");
    for (aimed, pixel) in [(false, [0, 99]), (true, [20, 9])] {
        // From 90 to 120 from top to bottom, with and without a sun.
        let at = |x, y| image::Luma([if [x, y] == pixel { 255 } else { 90 + y as u8 }]);
        image::GrayImage::from_fn(64, 32, at).save(&path).unwrap();
        let text = format!(
            "[rays]\nbounding_sphere = {{ radius = 3 }}\nlighting = \"path-tracing\"\n[sky]\nimage = {path:?}\n[[objects]]\nshape = \"sphere\"\n\
             material = \"grey\"\n[materials.grey]\nkind = \"phong\"\n"
        );
        let mut scene = scene(&text);
        if let (true, Some(picture)) = (aimed, scene.pictures.first_mut()) {
            // A sun is far brighter than an image of 8 bits can store.
            let pixels = picture.pixels.iter().map(|p| if p[0] > 0.99 { [1000.0; 3] } else { *p });
            picture.pixels = std::sync::Arc::new(pixels.collect());
        }
        assert_eq!(scene.aims_at_sky(), aimed);
        if let Some(paths) = &mut scene.rays.path_tracing {
            paths.light_sampling = false;
        }
        assert!(!scene.aims_at_sky());
    }
}
