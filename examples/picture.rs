//! Renders three frames of a black hole in front of a checkered wall, from a camera on a circle, without a scene file.

use std::error::Error;
use std::path::Path;
use std::sync::Arc;

use bentray::gpu::Gpu;
use bentray::model::camera::Pinhole;
use bentray::model::law::RoundHole;
use bentray::model::material::Phong;
use bentray::model::shape::{Plane, Sphere};
use bentray::output::save;
use bentray::render::{RenderSettings, Renderer};
use bentray::scene::{Camera, Light, LightSource, Pattern, Scene, Shadows, Transform};
use glam::{DVec2, DVec3};

fn scene() -> Scene {
    let hole = RoundHole::new(1.0, DVec3::ZERO);
    let mut scene = Scene::new(hole, 40.0);
    scene.image.size = [320, 200];
    let checker =
        Pattern::Checker { colors: [DVec3::splat(0.9), DVec3::new(0.1, 0.2, 0.4)], repeat: DVec2::splat(12.0) };
    let wall = scene.add_material("wall", checker, Phong::default());
    let red = scene.add_material("red", Pattern::Constant(DVec3::new(0.8, 0.1, 0.1)), Phong::default());
    let facing_us = DVec3::new(90.0, 0.0, 0.0);
    scene.add_object(Plane, Transform::new(DVec3::splat(20.0), facing_us, DVec3::new(0.0, 0.0, -15.0)), wall);
    scene.add_object(Sphere, Transform::new(DVec3::ONE, DVec3::ZERO, DVec3::new(5.0, 0.0, 0.0)), red);
    let source = LightSource::Point(DVec3::new(10.0, 10.0, 20.0));
    scene.lights.push(Light { shadows: Shadows::Straight, ..Light::new(source) });
    scene
}

/// Returns the camera after `turn` revolutions; it looks at the black hole.
fn camera(turn: f64) -> Option<Camera> {
    let (sin, cos) = (std::f64::consts::TAU * turn).sin_cos();
    Camera::look_at(DVec3::new(15.0 * sin, 2.0, 15.0 * cos), DVec3::ZERO, DVec3::Y, Arc::new(Pinhole { fov: 60.0 }))
}

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::open(None)?;
    let folder = std::env::temp_dir();
    let first = Scene { camera: camera(0.0), ..scene() };
    let mut renderer = Renderer::new(&gpu, &first, RenderSettings::default())?;
    for frame in 0..3 {
        let scene = Scene { camera: camera(0.02 * f64::from(frame)), ..first.clone() };
        renderer.set_scene(scene.clone())?;
        let rendering = renderer.render()?;
        let path = folder.join(format!("bentray_picture_{frame}.png"));
        save(Path::new(&path), &scene, &rendering)?;
        println!("{}: {}", path.display(), rendering.totals);
        assert!(rendering.totals.unfollowed() == 0, "every ray has an end");
    }
    Ok(())
}
