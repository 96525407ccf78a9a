//! Tests the images of cameras other than the pinhole: fisheyes, panoramas and stereo pairs.

#![allow(clippy::float_cmp)] // multiples of a quarter are exact

use std::sync::Arc;

use bentray::model::camera::{Corners, Fisheye, Panorama};
use bentray::program::{Layer, ProgramOptions};
use bentray::render::{Plane, RenderSettings, Renderer, Rendering, Status, pixel_starts};
use bentray::scene::Scene;
use glam::{DMat3, DVec3};

use crate::support::{gpu, scene};

/// A glowing ball in front of a sky, in straight space.
const BALL: &str = "[rays]\nbounding_sphere = { radius = 20 }\n[sky]\ncolor = [0.1, 0.2, 0.3]\n\
    [materials.m]\nkind = \"emissive\"\ncolor = { checker = [[1, 0.5, 0.2], [0.2, 0.9, 1]] }\n\
    [[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\n";

fn rendered(scene: &Scene, settings: RenderSettings) -> Rendering {
    let gpu = gpu();
    Renderer::new(&gpu, scene, settings).unwrap().render().unwrap()
}

fn with_status() -> RenderSettings {
    RenderSettings {
        options: ProgramOptions { layers: vec![Layer::Status], ..ProgramOptions::default() },
        ..RenderSettings::default()
    }
}

/// A turned sky, and the stars in it, are what a camera sees that is turned in the same way.
#[test]
fn a_turned_sky_is_seen_by_a_turned_camera() {
    let turn = |v: DVec3| {
        let [x, y, z] = [20_f64, 50.0, -35.0].map(f64::to_radians);
        DMat3::from_rotation_z(z) * DMat3::from_rotation_y(y) * DMat3::from_rotation_x(x) * v
    };
    for sky in [
        "image = \"data/stars.png\"",
        "faces = [F, F, F, F, F, F]",
        "stars = { file = \"data/stars.csv\", limit = 4, intensity = 1e5 }",
    ] {
        let sky = sky.replace('F', "\"data/graticule.png\"");
        let seen = |rotate: &str, ahead: DVec3, up: DVec3| {
            let [ahead, up] = [ahead, up].map(|v| v.to_array());
            let mut scene = scene(&format!(
                "[image]\nsize = [64, 48]\n[camera]\nposition = [0, 0, 0]\nlook_at = {ahead:?}\nup = {up:?}\nfov = 70\n\
                 [rays]\nbounding_sphere = {{ radius = 9 }}\n[sky]\nrotate = {rotate}\n{sky}\n"
            ));
            for picture in &mut scene.pictures {
                // Colors that change little from one texel to the next.
                let pixels = (0..32 * 16).map(|i| [(i % 32) as f32 / 32.0, (i / 32) as f32 / 16.0, 0.5]);
                picture.size = [32, 16];
                picture.pixels = Arc::new(pixels.collect());
            }
            rendered(&scene, RenderSettings::default()).band
        };
        let (a, b) = (seen("[0, 0, 0]", -DVec3::Z, DVec3::Y), seen("[20, 50, -35]", turn(-DVec3::Z), turn(DVec3::Y)));
        assert!(a.color[0].iter().any(|light| *light > 0.1), "{sky}");
        for (a, b) in a.color.iter().flatten().zip(b.color.iter().flatten()) {
            assert!((a - b).abs() < 1e-3 * a.abs().max(1.0), "{sky}: {a} {b}");
        }
    }
}

/// A panorama as large as the environment map, from any position in straight space, equals that map at pixel centers.
#[test]
fn a_panorama_of_a_bare_sky_is_the_sky() {
    let text = "[camera]\nkind = \"panorama\"\nposition = [1, 2, 3]\nlook_at = [1, 2, -9]\n\
        [rays]\nbounding_sphere = { radius = 1e-3, center = [1, 2, 3] }\n[sky]\nimage = \"data/stars.png\"\n";
    let mut scene = scene(text);
    let size = scene.pictures[0].size;
    let sky = scene.pictures[0].pixels.clone();
    let brightest = sky.iter().flatten().copied().fold(0.0, f32::max);
    let mut check = |fov: [f64; 2], first: [u32; 2], cut: [u32; 2]| {
        scene.image.size = cut;
        scene.camera.as_mut().unwrap().projection = Arc::new(Panorama { fov });
        let picture = rendered(&scene, RenderSettings::default());
        assert_eq!(picture.totals.unfollowed(), 0);
        let mut off = 0.0_f32;
        for i in 0..cut[0] * cut[1] {
            let (x, y) = (first[0] + i % cut[0], first[1] + i / cut[0]);
            for (channel, want) in picture.band.color.iter().zip(sky[(y * size[0] + x) as usize]) {
                off = off.max((channel[i as usize] - want).abs());
            }
        }
        println!("{fov:?}: off by {off:e} of {brightest}");
        // Positions in the sky err by 4e-7/π of its width (the error of the arc tangent), and neighboring texels may differ
        // by the full range; the sky is stored in 16 bits.
        let place = size[0] as f32 * (4e-7 / std::f32::consts::PI + 6.0 * f32::EPSILON);
        assert!(off <= brightest * (2.0 * place + 0.5 / 1024.0), "{fov:?}: off by {off}");
    };
    check([360.0, 180.0], [0, 0], size);
    let part = size.map(|side| side / 4);
    let first = [(size[0] - part[0]) / 2, (size[1] - part[1]) / 2];
    check([90.0, 45.0], first, part);
}

/// Each half of a stereo pair is bit-identical to the image of a camera in the position of that eye.
#[test]
fn each_view_is_the_picture_of_its_eye() {
    for kind in [
        "kind = \"pinhole\"",
        "kind = \"orthographic\"\nheight = 3",
        "kind = \"fisheye\"\nfov = 100",
        "kind = \"panorama\"",
    ] {
        for (layout, view) in [("side-by-side", [24_u32, 20]), ("top-bottom", [48, 10])] {
            let text = format!(
                "[image]\nsize = [48, 20]\n[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\n{kind}\n\
                 stereo = {{ separation = 0.5, layout = \"{layout}\" }}\n{BALL}"
            );
            let mut scene = scene(&text);
            let pair = rendered(&scene, with_status());
            let camera = scene.camera.as_mut().unwrap();
            let eyes = camera.eyes();
            assert_eq!(eyes, [DVec3::new(-0.25, 0.0, 5.0), DVec3::new(0.25, 0.0, 5.0)]);
            camera.stereo = None;
            scene.image.size = view;
            for (k, eye) in eyes.into_iter().enumerate() {
                scene.camera.as_mut().unwrap().position = eye;
                let alone = rendered(&scene, with_status());
                assert!(alone.totals.count(Status::Hit) > 0, "{kind}: {}", alone.totals);
                let corner = if layout == "top-bottom" { [0, k * 10] } else { [k * 24, 0] };
                for (whole, half) in pair.band.color.iter().zip(&alone.band.color) {
                    for (i, value) in half.iter().enumerate() {
                        let (x, y) = (corner[0] + i % view[0] as usize, corner[1] + i / view[0] as usize);
                        assert!(
                            whole[y * 48 + x].to_bits() == value.to_bits(),
                            "{kind}, {layout}: view {k}, pixel {i}"
                        );
                    }
                }
            }
        }
    }
}

/// Returns the position of the ball's center in each view, as a fraction of half of the view's width.
fn places(camera: &str) -> [f64; 2] {
    let text = format!("[image]\nsize = [800, 400]\n[camera]\nposition = [0, 0, 5]\n{camera}\n{BALL}radius = 0.25\n");
    let picture = rendered(&scene(&text), with_status());
    let Some(Plane::Id(statuses)) = picture.band.layer(Layer::Status) else { panic!("a status layer") };
    let hit = Status::Hit.code();
    [0, 400].map(|left| {
        let hits = |(i, code): (usize, &u32)| (*code == hit).then_some(i % 800);
        let columns: Vec<usize> =
            statuses.iter().enumerate().filter_map(hits).filter(|x| x / 400 == left / 400).collect();
        let mean = columns.iter().sum::<usize>() as f64 / columns.len() as f64 + 0.5 - left as f64;
        mean / 200.0 - 1.0
    })
}

/// A ball at a distance of 5 is shifted by its parallax if the views are parallel. If the views converge at it, it is not
/// shifted; if it is closer than that, it is further right for the left eye.
#[test]
fn views_cross_where_they_shall() {
    let stereo = |more: &str| format!("stereo = {{ separation = 0.5{more} }}");
    let ball = |camera: &str, want: f64, slack: f64| {
        let [left, right] = places(camera);
        assert!((left - want).abs() < slack && (right + want).abs() < slack, "{camera}: {left} {right}, not ±{want}");
    };
    // A pixel is 1/200. The ball's outline is an ellipse around a point that is further out than its center by 1e-4.
    let shift = 0.25 / 5.0;
    ball(&format!("fov = 90\n{}", stereo("")), shift, 4e-3);
    ball(&format!("fov = 90\n{}", stereo(", convergence = 5")), 0.0, 1e-3);
    ball(&format!("fov = 90\n{}", stereo(", convergence = 10")), shift / 2.0, 3e-3);
    let fisheye = |fov: f64, more: &str| format!("kind = \"fisheye\"\nfov = {fov}\n{}", stereo(more));
    ball(&fisheye(90.0, ""), shift.atan() / 45.0_f64.to_radians(), 2e-3);
    ball(&fisheye(90.0, ", convergence = 5"), 0.0, 1e-3);
    ball(&format!("kind = \"panorama\"\nfov = [90, 90]\n{}", stereo(", convergence = 5")), 0.0, 1e-3);
    // Parallel rays from parallel planes have only the distance between the eyes as parallax; for converging views it depends on depth.
    ball(&format!("kind = \"orthographic\"\nheight = 4\n{}", stereo("")), 0.125, 1e-3);
    ball(&format!("kind = \"orthographic\"\nheight = 4\n{}", stereo(", convergence = 5")), 0.0, 1e-3);
}

const HOLE: &str = "[law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 30 }\nmethod = \"planar\"\n\
    [sky]\ncolor = [0.1, 0.2, 0.3]\n";

/// Outside the disk there are no rays, for either observer and for a sky at infinity: the counts there are neither sky nor
/// errors, and the alpha of every pixel is the fraction of its samples that are inside.
#[test]
fn outside_the_disk_there_is_nothing() {
    for (frame, more) in [("coordinate", ""), ("static", ""), ("static", "sky_at_infinity = true\n")] {
        for corners in ["black", "transparent"] {
            let text = format!(
                "[image]\nsize = [96, 64]\n[camera]\nposition = [0, 2, 40]\nobserver = \"{frame}\"\nkind = \"fisheye\"\nfov = 300\n\
                 corners = \"{corners}\"\n{}",
                HOLE.replace("[sky]", &format!("{more}[sky]"))
            );
            let mut scene = scene(&text);
            scene.image.samples = 4;
            let picture = rendered(&scene, with_status());
            let totals = &picture.totals;
            assert_eq!((totals.rays, totals.unfollowed()), (4 * 96 * 64, 0), "{totals}");
            let inside = (totals.rays - totals.count(Status::Outside)) as f64;
            let disk = 4.0 * std::f64::consts::PI * 32.0 * 32.0;
            assert!((inside / disk - 1.0).abs() < 0.01, "{frame}: {inside} samples, but the disk has {disk}");
            assert!(totals.count(Status::Captured) > 20 && totals.count(Status::Escaped) > 9000, "{totals}");
            let Some(Plane::Id(statuses)) = picture.band.layer(Layer::Status) else { panic!("a status layer") };
            let (mut covered, outside) = (0.0, Status::Outside.code());
            for (i, status) in statuses.iter().enumerate() {
                let (x, y) = ((i % 96) as f64 - 47.5, (i / 96) as f64 - 31.5);
                let (near, far) = (x.hypot(y) < 32.0 - 0.71, x.hypot(y) > 32.0 + 0.71);
                assert!(!near || *status != outside, "{x} {y}");
                assert!(!far || *status == outside && picture.band.color.iter().all(|c| c[i] == 0.0), "{x} {y}");
                if let Some(alpha) = &picture.band.alpha {
                    assert!(!(near && alpha[i] != 1.0 || far && alpha[i] != 0.0), "{x} {y}: {}", alpha[i]);
                    covered += 4.0 * f64::from(alpha[i]);
                }
            }
            assert_eq!(picture.band.alpha.is_some(), corners == "transparent");
            assert!(corners == "black" || covered == inside, "{covered} of {inside}");
        }
    }
}

/// The shadow of a black hole for a static observer has the radius sin θ = 3√3 M √(1 − 2M/r)/r. In an image with a constant
/// angle per pixel it repeats every 360°, at the angles 2πk ± θ.
#[test]
fn the_shadow_has_its_size_in_a_fisheye() {
    let r: f64 = 6.0;
    let angle = f64::asin((27.0 * (1.0 - 2.0 / r)).sqrt() / r);
    for fov in [120.0, 900.0_f64] {
        let text = format!(
            "[image]\nsize = [2001, 2001]\n[camera]\nkind = \"fisheye\"\nposition = [0, 0, 6]\nfov = {fov}\nobserver = \"static\"\n{}",
            HOLE.replace("color = [0.1, 0.2, 0.3]", "color = [1, 1, 1]")
        );
        let gpu = gpu();
        let scene = scene(&text);
        let pixels: Vec<[u32; 2]> = (0..2001).map(|x| [x, 1000]).collect();
        let (rays, _) = bentray::render::trace_pixels(&gpu, &scene, &RenderSettings::default(), &pixels).unwrap();
        let half = 0.5 * fov.to_radians();
        let shadow = |x: i32| {
            let turned = (f64::from(x - 1000) / 1000.5 * half).abs() % std::f64::consts::TAU;
            turned.min(std::f64::consts::TAU - turned) < angle
        };
        let wrong = (0..2001).filter(|x| (rays[*x as usize].status == Status::Captured) != shadow(*x)).count();
        assert!(wrong <= 2, "{fov}: {wrong} of 2001 pixels are wrong");
        assert!(rays.iter().all(|ray| ray.status != Status::Outside));
    }
}

/// Tiles of any size give identical pairs of views, with samples and alpha.
#[test]
fn tiles_do_not_show_in_pairs() {
    let text = format!(
        "[image]\nsize = [64, 48]\nsamples = 3\n[camera]\nposition = [0, 0, 5]\nkind = \"fisheye\"\nfov = 400\n\
         corners = \"transparent\"\nstereo = {{ separation = 0.5, convergence = 4 }}\n{BALL}"
    );
    let scene = scene(&text);
    let projection = &scene.camera.as_ref().unwrap().projection;
    assert!(matches!(projection.downcast(), Some(Fisheye { corners: Corners::Transparent, .. })));
    let whole = rendered(&scene, with_status());
    for tile_pixels in [64, 1000] {
        let tiled = rendered(&scene, RenderSettings { tile_pixels, ..with_status() });
        assert!(whole.band == tiled.band, "tiles of {tile_pixels} pixels");
        assert_eq!(whole.totals.by_status, tiled.totals.by_status);
    }
}

/// In 64 bits the rays of every camera start in 64-bit directions, also for a pixel whose center is not a 32-bit number.
#[test]
fn rays_of_64_bits_start_in_directions_of_64_bits() {
    let pixel = [2, 0];
    let [x, y]: [f64; 2] = [5.0 / 7.0 - 1.0, 1.0 - 1.0 / 3.0];
    let tan = 20.0_f64.to_radians().tan();
    let rho = (7.0 / 3.0 * x).hypot(y);
    let turned = |angle: f64| angle.to_radians().sin_cos();
    let (longitude, latitude) = (turned(50.0 * x), turned(30.0 * y));
    let (off, ahead) = turned(10.0 * rho);
    for (camera, told) in [
        ("kind = \"pinhole\"\nfov = 40", DVec3::new(7.0 / 3.0 * tan * x, tan * y, -1.0).normalize()),
        ("kind = \"fisheye\"\nfov = 20", DVec3::new(7.0 / 3.0 * x / rho * off, y / rho * off, -ahead)),
        (
            "kind = \"panorama\"\nfov = [100, 60]",
            DVec3::new(longitude.0 * latitude.1, latitude.0, -longitude.1 * latitude.1),
        ),
    ] {
        for (precision, bound) in [("f32", 2e-7), ("f64", 4e-15)] {
            let scene = scene(&format!(
                "[image]\nsize = [7, 3]\n[camera]\nposition = [0, 0, 1]\n{camera}\n[rays]\nbounding_sphere = {{ radius = 9 }}\n\
                 precision = \"{precision}\"\n"
            ));
            let start = pixel_starts(&gpu(), &scene, &RenderSettings::default(), &[pixel]).unwrap()[0];
            let off = DVec3::from_slice(&start[3..]).distance(told);
            println!("{camera} {precision}: {off:e}");
            assert!(off < bound, "{camera} {precision}: off by {off:e}");
        }
    }
}

/// A moving camera outside the bounding sphere sees along the same lines as one whose bounding sphere contains it.
#[test]
fn rays_come_to_the_bounding_sphere_as_an_observer_sees_them() {
    let starts = |radius: f64| {
        let scene = scene(&format!(
            "[image]\nsize = [5, 3]\n[camera]\nposition = [50, 4, 0]\nlook_at = [0, 40, 0]\nfov = 40\nobserver = \"boosted\"\n\
             velocity = [0, 0.6, 0]\n[law]\nkind = \"metric\"\nline_element = \"-dt^2 + dx^2 + dy^2 + dz^2\"\nscale = \"9\"\n\
             [rays]\nbounding_sphere = {{ radius = {radius} }}\n"
        ));
        let pixels: Vec<[u32; 2]> = (0..15).map(|i| [i % 5, i / 5]).collect();
        pixel_starts(&gpu(), &scene, &RenderSettings::default(), &pixels).unwrap()
    };
    let mut entered = 0;
    for (inside, outside) in starts(90.0).iter().zip(starts(20.0)) {
        let [from, there] = [&inside[..], &outside].map(|start| DVec3::from_slice(start));
        let [v, along] = [&inside[3..], &outside[3..]].map(DVec3::from_slice);
        assert!(v.distance(along) < 1e-5, "{v} and {along}");
        let way = there - from;
        assert!(way.cross(v).length() < 1e-4 * v.length(), "{from} along {v} does not reach {there}");
        entered += usize::from(way.length() > 1.0);
    }
    assert!(entered >= 3, "{entered} rays enter");
}
