//! Tests whole images: their cost on the device, tiles, sampling, and a few references.

use std::path::Path;
use std::process::Command;
use std::sync::Arc;

use bentray::gpu::{Geometry, memory};
use bentray::model::shape::{Cylinder, Disk};
use bentray::program::{Layer, Program, ProgramOptions, Schedule};
use bentray::render::{Band, Plane, RenderSettings, Renderer, Rendering, Status, pixel_starts, trace_paths};
use bentray::scene::{Object, Scene};
use glam::DVec3;

use crate::support::{gpu, scene, shipped_scenes};

const HOLE: &str = "[image]\nsize = [96, 64]\n[camera]\nposition = [0, 2, 15]\n[law]\nkind = \"schwarzschild\"\n\
    [rays]\nbounding_sphere = { radius = 30 }\n[sky]\nimage = \"data/stars.png\"\n\
    [materials.m]\ndiffuse = { checker = [[1, 0.2, 0.1], [0.9, 0.9, 0.9]] }\n\
    [[objects]]\nshape = \"sphere\"\ncenter = [5, 0, -3]\nradius = 2\nmaterial = \"m\"\n\
    [[lights]]\nkind = \"point\"\nposition = [10, 10, 20]\n";

/// State takes at most 104 bytes per pixel, whatever the number of segments; layers and other schedules cost extra memory.
#[test]
fn state_on_the_device_is_small() {
    for path in shipped_scenes() {
        let mut scene = Scene::load(&path, &[]).unwrap();
        let geometry = Geometry::new(&scene);
        let bytes = |scene: &Scene, options: &ProgramOptions| {
            let program = Program::new(scene, &geometry.analysis, options, geometry.extent()).unwrap();
            memory(&program).bytes_per_pixel()
        };
        let fused = || ProgramOptions { schedule: Schedule::Fused, ..ProgramOptions::default() };
        let plain = bytes(&scene, &fused());
        // The grid of rays, the starlight of a pixel, and the first image in its cell.
        let stars = if scene.has_stars() { 3 * 16 + 4 } else { 0 };
        // W, if a path ends by τ, in two slots.
        let most = stars + if scene.rays.max_parameter.is_some() { 104 + 2 * 16 } else { 104 };
        assert!(plain <= most, "{}: {plain} bytes per pixel", path.display());
        let layers = |is_of_crossings| -> Vec<Layer> {
            let own = |layer: &Layer| layer.is_of_crossings() == is_of_crossings && !layer.is_of_bundles();
            Layer::ALL.into_iter().filter(own).collect()
        };
        let layered = bytes(&scene, &ProgramOptions { layers: layers(false), ..fused() });
        // Depth, segments, object, status, steps and redshift at 4 bytes, two vectors at 12; the summed steps, rejections
        // and lengths; and up to 12 bytes of padding before each vector and at the end.
        assert!(layered - plain <= 6 * 4 + 2 * 12 + 3 * 4 + 3 * 12, "{}: {layered}", path.display());
        // The start, three rows for each of four crossings, the count with padding; and τ, if nothing else needs it.
        let crossed = bytes(&scene, &ProgramOptions { layers: layers(true), ..fused() });
        assert!(crossed - plain <= 13 * 16 + 16 + 2 * 16, "{}: {crossed}", path.display());
        scene.rays.max_segments = 100_000;
        assert_eq!(bytes(&scene, &fused()), plain);
        // A path in one pass only stores its color, which takes as much as four numbers.
        assert_eq!(bytes(&scene, &ProgramOptions::default()), stars + 4 * 4, "{}", path.display());
        let masks = Schedule::Paper.masks();
        let paper = bytes(&scene, &ProgramOptions { schedule: Schedule::Paper, masks, ..ProgramOptions::default() });
        assert!(paper <= most, "{}: {paper} bytes per pixel", path.display());
    }
}

fn rendered(scene: &Scene, settings: RenderSettings) -> Rendering {
    let gpu = gpu();
    Renderer::new(&gpu, scene, settings).unwrap().render().unwrap()
}

/// The depth of bent rays is the length of their paths as `trace` writes them, and equal for every schedule.
#[test]
fn depth_is_the_length_of_the_path() {
    let scene = scene(HOLE);
    let layers = vec![Layer::Depth, Layer::Status];
    let band = |schedule: Schedule| {
        let options =
            ProgramOptions { schedule, masks: schedule.masks(), layers: layers.clone(), ..ProgramOptions::default() };
        rendered(&scene, RenderSettings { options, ..RenderSettings::default() }).band
    };
    let [whole, fused, segment] = [Schedule::Whole, Schedule::Fused, Schedule::Segment].map(band);
    let depths = |band: &Band| match band.layer(Layer::Depth) {
        Some(Plane::Scalar(depths)) => depths.clone(),
        _ => panic!("no depth"),
    };
    let found = depths(&whole);
    assert_eq!(found, depths(&fused));
    assert_eq!(found, depths(&segment));
    let Some(Plane::Id(status)) = whole.layer(Layer::Status) else { panic!("no status") };
    let (width, gpu) = (scene.image.size[0] as usize, gpu());
    let hits: Vec<usize> = (0..found.len()).filter(|i| status[*i] == Status::Hit.code()).step_by(7).collect();
    assert!(hits.len() > 20, "{}", hits.len());
    assert!((0..found.len()).all(|i| (found[i].to_bits() == 1e10_f32.to_bits()) == (status[i] != Status::Hit.code())));
    // Chords of steps this fine are shorter than their arcs by less than 1e-4 of them.
    let fine = crate::support::scene(&HOLE.replace("[rays]\n", "[rays]\nmethod = \"rk4\"\nscaled_step = 0.02\n"));
    let pixels: Vec<[u32; 2]> = hits.iter().map(|i| [(i % width) as u32, (i / width) as u32]).collect();
    let settings = RenderSettings::default();
    let starts = pixel_starts(&gpu, &fine, &settings, &pixels).unwrap();
    let paths = trace_paths(&gpu, &fine, &settings, &starts).unwrap();
    for (i, (_, path)) in hits.iter().zip(paths) {
        let length: f64 = path.windows(2).map(|pair| DVec3::from(pair[0].x).distance(pair[1].x.into())).sum();
        assert!((f64::from(found[*i]) / length - 1.0).abs() < 1e-3, "{} instead of {length}", found[*i]);
    }
}

/// An accretion disk around a spinning black hole, whose redshift depends on the direction of each ray at the camera.
const SPINNING: &str = "[image]\nsize = [96, 64]\n[camera]\nposition = [18, 3, 4]\nobserver = \"static\"\nredshift = true\n\
    [law]\nkind = \"kerr-newman\"\nspin = 0.9\naxis = [0, 1, 0]\n[rays]\nbounding_sphere = { radius = 60 }\n\
    [materials.m]\nkind = \"accretion\"\ntemperature = 7000\nopacity = 0.5\n\
    [[objects]]\nshape = \"disk\"\nmaterial = \"m\"\nradius = 20\ninner_radius = 3\n";

/// Tiles of any size give identical images, including samples and layers.
#[test]
fn tiles_do_not_show() {
    for text in [HOLE, SPINNING] {
        tiles_of_do_not_show(scene(text));
    }
}

fn tiles_of_do_not_show(mut scene: Scene) {
    scene.image.samples = 3;
    // The grid for bundles has more rays in more tiles.
    let layers = Layer::ALL.into_iter().filter(|layer| !layer.is_of_bundles()).collect();
    let options = ProgramOptions { layers, ..ProgramOptions::default() };
    let whole = rendered(&scene, RenderSettings { options: options.clone(), ..RenderSettings::default() });
    for tile_pixels in [64, 1000] {
        let tiled =
            rendered(&scene, RenderSettings { options: options.clone(), tile_pixels, ..RenderSettings::default() });
        assert!(whole.band == tiled.band, "tiles of {tile_pixels} pixels");
        assert_eq!(whole.totals.by_status, tiled.totals.by_status);
        assert_eq!(whole.totals.steps, tiled.totals.steps);
    }
}

/// A sky of many rows is copied to the device band by band, in 16 bits or in the 32 that its values need.
#[test]
fn a_large_sky_is_where_it_is_in_its_file() {
    const WIDTH: u32 = 1024;
    const BLOCK: u32 = 250;
    const BLOCKS: u32 = 10;
    let mut scene = scene(
        "[image]\nsize = [4, 10]\n[camera]\nkind = \"panorama\"\nposition = [0, 0, 1]\n[rays]\nbounding_sphere = { radius = 9 }\n\
         [sky]\nimage = \"data/stars.png\"\n",
    );
    for scale in [1.0, 10_000.0] {
        let level = |block: u32| [scale * block as f32, scale * (BLOCKS - block) as f32, scale];
        let pixels = (0..WIDTH * BLOCK * BLOCKS).map(|i| level(i / (WIDTH * BLOCK)));
        scene.pictures[0] = bentray::scene::Picture {
            size: [WIDTH, BLOCK * BLOCKS],
            pixels: Arc::new(pixels.collect()),
            name: "blocks".to_owned(),
            notes: Vec::new(),
        };
        let band = rendered(&scene, RenderSettings::default()).band;
        for (i, row) in (0..BLOCKS).flat_map(|block| [block; 4]).enumerate() {
            let found = [0, 1, 2].map(|channel: usize| band.color[channel][i]);
            let near = found.iter().zip(level(row)).all(|(a, b)| (a - b).abs() <= 1e-6 * b);
            assert!(near, "scale {scale}, row {row}: {found:?}");
        }
    }
}

/// Every ray is counted once, by its termination status.
#[test]
fn every_ray_is_counted() {
    let mut scene = scene(HOLE);
    scene.image.samples = 2;
    let picture = rendered(&scene, RenderSettings::default());
    assert_eq!(picture.totals.rays, 2 * 96 * 64);
    for status in [Status::Hit, Status::Escaped, Status::Captured] {
        assert!(picture.totals.count(status) > 100, "{}", picture.totals);
    }
    assert_eq!(picture.totals.unfollowed(), 0);
}

/// Multi-jittered samples converge: sixteen are closer to sixty-four than four are.
#[test]
fn samples_converge() {
    let mut scene = scene(HOLE);
    let mut with = |samples: u32| {
        scene.image.samples = samples;
        rendered(&scene, RenderSettings::default()).band.color.concat()
    };
    let (few, more, many) = (with(4), with(16), with(64));
    let error = |a: &[f32]| -> f64 { a.iter().zip(&many).map(|(a, b)| f64::from(a - b).powi(2)).sum::<f64>().sqrt() };
    assert!(error(&more) < 0.7 * error(&few), "{} against {}", error(&more), error(&few));
}

/// For a static observer at r = 20 the shadow of a black hole has the radius of
/// the closed form, sin θ = 3√3 M √(1 − 2M/r)/r, to within a pixel.
#[test]
fn the_shadow_has_its_size() {
    for (frame, sin2) in [
        ("static", 27.0 * (1.0 - 2.0 / 20.0) / 400.0),
        // Coordinate directions: sin² θ = 27M²/(r² + 54M³/r).
        ("coordinate", 27.0 / (400.0 + 54.0 / 20.0)),
    ] {
        // Vertical, for 3 rows; the image is then as wide as it is distant.
        let fov = (2.0 * (1.5_f64 / 401.0).atan()).to_degrees();
        let text = format!(
            "[image]\nsize = [401, 3]\n[camera]\nposition = [0, 0, 20]\nfov = {fov}\nobserver = \"{frame}\"\n\
             [law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = {{ radius = 50 }}\n[sky]\ncolor = [1, 1, 1]\n"
        );
        let scene = scene(&text);
        let picture = rendered(&scene, RenderSettings::default());
        let row = &picture.band.color[0][401..802];
        let dark = row.iter().filter(|v| **v == 0.0).count() as f64;
        let angle: f64 = f64::asin(f64::sqrt(sin2));
        let expected = 2.0 * angle.tan() * 401.0;
        assert!((dark - expected).abs() <= 2.0, "{frame}: {dark} dark pixels, {expected} expected");
    }
}

/// A tilted and flattened cylinder, inside a ring, over a disk.
const ROUND: &str = "[image]\nsize = [96, 72]\n[camera]\nposition = [1, 5, 12]\n[rays]\nbounding_sphere = { radius = 30 }\n\
    [materials.m]\nkind = \"emissive\"\ncolor = { checker = [[1, 0.2, 0.1], [0.1, 0.3, 0.9]] }\n\
    [[objects]]\nshape = \"cylinder\"\nradius = 1.5\nheight = 4\naxis = [1, 2, 1]\nscale = [1, 1, 0.5]\nmaterial = \"m\"\n\
    [[objects]]\nshape = \"disk\"\nradius = 4\ninner_radius = 2.5\nnormal = [0, 1, 0.3]\nmaterial = \"m\"\n\
    [[objects]]\nshape = \"disk\"\ncenter = [0, -3, 0]\nradius = 5\nmaterial = \"m\"\n";

/// Returns the crossings of a line with an object's faces, from the points of the line on the planes and circles.
fn crossings(object: &Object, from: DVec3, along: DVec3) -> Vec<f64> {
    let inverse = object.transform.0.inverse();
    let (p, d) = (inverse.transform_point3(from), inverse.transform_vector3(along));
    let rho = |t: f64| (p.x + t * d.x).hypot(p.z + t * d.z);
    let flat = |y: f64| (y - p.y) / d.y;
    if let Some(Disk { hole }) = object.shape.downcast() {
        return [flat(0.0)].into_iter().filter(|t| (*hole..=1.0).contains(&rho(*t))).collect();
    }
    assert!(object.shape.downcast::<Cylinder>().is_some(), "no other shape here");
    let (dd, pd, pp) = (d.x * d.x + d.z * d.z, p.x * d.x + p.z * d.z, p.x * p.x + p.z * p.z);
    let root = (pd * pd - dd * (pp - 1.0)).sqrt();
    let mantle = [(-pd - root) / dd, (-pd + root) / dd].into_iter().filter(|t| (p.y + t * d.y).abs() <= 1.0);
    mantle.chain([flat(1.0), flat(-1.0)].into_iter().filter(|t| rho(*t) <= 1.0)).collect()
}

/// Compares the object in each pixel with the nearest of all crossings.
#[test]
fn cylinders_and_disks_are_where_they_are() {
    let scene = scene(ROUND);
    let options = ProgramOptions { layers: vec![Layer::Object], ..ProgramOptions::default() };
    let picture = rendered(&scene, RenderSettings { options, ..RenderSettings::default() });
    let [(_, Plane::Scalar(seen))] = &picture.band.layers[..] else { panic!("one layer") };
    let camera = scene.camera.as_ref().expect("a camera");
    let half = 25_f64.to_radians().tan();
    let (mut off, mut count) = (0, [0; 4]);
    for (i, seen) in seen.iter().enumerate() {
        let (column, row) = ((i % 96) as f64 + 0.5, (i / 96) as f64 + 0.5);
        let v = camera.forward + half * ((column - 48.0) / 36.0 * camera.right - (row - 36.0) / 36.0 * camera.up);
        let all = scene.objects.iter().enumerate();
        let all = all.flat_map(|(k, object)| crossings(object, camera.position, v).into_iter().map(move |t| (t, k)));
        let nearest = all.filter(|(t, _)| *t > 0.0).min_by(|a, b| a.0.total_cmp(&b.0));
        let expected = nearest.map_or(-1.0, |(_, k)| k as f32);
        off += u32::from(seen.to_bits() != f32::to_bits(expected));
        count[(expected + 1.0) as usize] += 1;
    }
    println!("{off} pixels differ, of {count:?}");
    assert!(count.iter().all(|n| *n > 300), "{count:?}");
    assert!(off <= 3, "{off} pixels differ");
}

/// The first image of the README is the one that `make render` makes. Small copies are compared in sRGB values, whose steps
/// are about equally visible, with a tolerance for the noise of the samples.
#[test]
fn the_readme_shows_what_is_rendered() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let reference = image::open(root.join("scenes/pictures/black_hole.png")).unwrap().to_rgb8();
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("picture.png");
    let mut command = Command::new(env!("CARGO_BIN_EXE_bentray"));
    command.args(["render", "--size", "480x270", "--samples", "4"]);
    command.arg(root.join("scenes/black_hole.toml")).arg("-o").arg(&picture).env("BENTRAY_CACHE", "");
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let rendered = image::open(picture).unwrap().to_rgb8();
    let small = |picture: &image::RgbImage| image::imageops::thumbnail(picture, 96, 54);
    let (a, b) = (small(&reference), small(&rendered));
    let off = a.as_raw().iter().zip(b.as_raw()).map(|(a, b)| f64::from(a.abs_diff(*b))).collect::<Vec<_>>();
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    let far = off.iter().filter(|d| **d > 40.0).count();
    assert!(
        mean < 4.0 && far < off.len() / 100,
        "off by {mean} of 255 on average, by more than 40 in {far} of {}",
        off.len()
    );
}
