//! Defines a custom law: light in a harmonic trap, dv = −k x, where every orbit is an ellipse that closes after 2π/√k.

use std::error::Error;

use bentray::gpu::Gpu;
use bentray::model::law::{Invariant, Law};
use bentray::model::{Binding, Value, Wgsl};
use bentray::render::{RenderSettings, trace};
use bentray::scene::Scene;
use glam::DVec3;

/// The functions that a law must provide; `shaders/README.md` describes their contracts.
const TRAP: &str = "
struct Law {
    stiffness: Real,
}

@group(0) @binding(67) var<uniform> law: Law;

fn law_ray_constant(p: Phase) -> Real {
    return 0.0;
}

fn law_acceleration(x: Real3, held: Real) -> Real3 {
    return -law.stiffness * x;
}

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(x, v);
}

fn law_projected(p: Phase) -> Phase {
    return p;
}

fn law_scale(p: Phase) -> Real {
    return inverseSqrt(law.stiffness);
}
";

#[derive(Debug, Clone, PartialEq)]
struct Trap {
    stiffness: f64,
}

impl Law for Trap {
    fn parts(&self) -> Vec<Wgsl> {
        vec!["law/accelerated".into(), Wgsl::Text { file: "trap.wgsl".into(), text: TRAP.into() }]
    }

    fn values(&self) -> Vec<Binding> {
        vec![Binding::one("law", vec![("stiffness".into(), Value::Float(self.stiffness))])]
    }

    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let energy = 0.5 * (v.length_squared() + self.stiffness * x.length_squared());
        vec![Invariant { name: "energy", value: energy, size: energy }]
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::open(None)?;
    let mut scene = Scene::new(Trap { stiffness: 0.25 }, 50.0);
    // One revolution.
    scene.rays.max_parameter = Some(std::f64::consts::TAU / 0.5);
    let rays = [[3.0, 0.0, 0.0, 0.0, 1.0, 0.0], [0.0, 2.0, 1.0, 0.5, 0.0, 0.3]];
    let (ends, totals) = trace(&gpu, &scene, &RenderSettings::default(), &rays)?;
    println!("{totals}");
    for (ray, end) in rays.iter().zip(&ends) {
        let off = DVec3::from(end.x).distance(DVec3::from_slice(&ray[..3]));
        println!("{}: back within {off:.1e} of its start", end.status.name());
        assert!(off < 1e-3, "the orbit is closed");
    }
    Ok(())
}
