//! Traces rays without an image, and compares the deflection by a black hole with Einstein's 4M/b for light that passes far away.

use std::error::Error;

use bentray::gpu::Gpu;
use bentray::model::law::RoundHole;
use bentray::render::{RenderSettings, Status, trace};
use bentray::scene::Scene;
use glam::DVec3;

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::open(None)?;
    let hole = RoundHole::new(1.0, DVec3::ZERO);
    let mut scene = Scene::new(hole, 1000.0);
    // Continue the rays to infinity at both ends, in closed form.
    scene.rays.sky_at_infinity = true;
    let impacts = [6.0, 10.0, 30.0, 100.0, 300.0];
    let rays = impacts.map(|b| [-2000.0, b, 0.0, 1.0, 0.0, 0.0]);
    let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &rays)?;
    println!("{:>8}{:>14}{:>14}", "b / M", "deflection", "4M/b");
    for (b, end) in impacts.iter().zip(&ends) {
        let turned = DVec3::from(end.v).angle_between(DVec3::X);
        println!("{b:>8}{turned:>14.6}{:>14.6}", 4.0 / b);
        assert!(end.status == Status::Escaped);
    }
    let last = DVec3::from(ends[4].v).angle_between(DVec3::X);
    assert!((last * 300.0 / 4.0 - 1.0).abs() < 0.02, "far away the deflection is 4M/b");
    Ok(())
}
