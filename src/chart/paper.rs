//! The 2004 paper's measurements (W04 §6): Table 1's four laws, Figure 5's growing number of spheres, and the case of both under
//! every schedule.
//!
//! The paper names the viewport (800×600), the number of spheres, segments and steps, but not the scene, the camera or the step:
//! these are ours. "No acceleration" is every pixel in every pass with a fixed step; "acceleration" is early termination and step
//! doubling by the paper's rule.

use std::fmt::Write as _;
use std::time::Duration;

use crate::gpu::Gpu;
use crate::program::{Choice, Purpose, Schedule};
use crate::render::{RenderError, Renderer, Settings};
use crate::scene::{Scene, SceneError};

/// Seconds of Table 1 without acceleration: Lorenz, potential field, varying index, Schwarzschild.
pub const PLAIN_2004: [f64; 4] = [3.87, 4.22, 3.35, 4.91];
/// Seconds of Table 1 with acceleration.
pub const ACCELERATED_2004: [f64; 4] = [3.13, 1.16, 2.42, 3.79];

/// The fixed Euler step of the benchmark's scene: 300 of them lead from the camera through it.
const STEP: f64 = 0.15;

/// The paper's case on a device.
#[derive(Debug)]
pub struct PaperBench<'a> {
    /// The device.
    pub gpu: &'a Gpu,
    /// Each time is the median of so many.
    pub repeats: usize,
    /// Width and height: the paper's 800×600 unless it is a trial.
    pub size: [u32; 2],
}

/// One measured time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time on the device for integration, intersection and termination.
    pub advance: Duration,
    /// Ray-steps that were computed.
    pub ray_steps: u64,
}

impl Sample {
    /// Nanoseconds for one step of one ray.
    #[must_use]
    pub fn ns_per_ray_step(&self) -> f64 {
        self.advance.as_secs_f64() * 1e9 / self.ray_steps.max(1) as f64
    }
}

/// The same case under each schedule, without masks and with them.
#[derive(Debug, Clone)]
pub struct Schedules(pub Vec<(&'static str, Sample, Sample)>);

/// A law of Table 1.
#[derive(Debug, Clone, Copy)]
pub struct TableRow {
    /// Its name in the paper.
    pub law: &'static str,
    /// Without acceleration.
    pub plain: Sample,
    /// With it.
    pub accelerated: Sample,
}

const LAWS: [(&str, &str); 4] = [
    ("Lorenz system", "kind = \"lorenz\"\norder = 2\nsigma = 0.1\nrho = 0.28\nbeta = 0.027"),
    (
        "Potential field",
        "kind = \"sources\"\nsources = [{ position = [0, 0, 0], strength = 0.02, falloff = { cubic = 12 } }]",
    ),
    (
        "Varying index",
        "kind = \"medium\"\nindex = { kind = \"explosion\", radius = 12, amplitude = 0.1, frequency = 0.4 }",
    ),
    ("Schwarzschild", "kind = \"schwarzschild\"\nform = \"geodesic\""),
];

impl PaperBench<'_> {
    /// 300 Euler steps in 30 segments over 10 spheres in Schwarzschild spacetime, under every schedule.
    pub fn schedules(&self) -> Result<Schedules, RenderError> {
        let scene = self.scene(LAWS[3].1, 10, 30, false)?;
        let measured = Schedule::ALL.map(|schedule| {
            Ok((schedule.name(), self.measure(&scene, schedule, false)?, self.measure(&scene, schedule, true)?))
        });
        measured.into_iter().collect::<Result<_, RenderError>>().map(Schedules)
    }

    /// Table 1: four laws, 300 steps in 30 segments over 10 spheres, by the fused schedule.
    pub fn table(&self) -> Result<Vec<TableRow>, RenderError> {
        let row = |(law, text): (&'static str, &str)| {
            let plain = self.measure(&self.scene(text, 10, 30, false)?, Schedule::Fused, false)?;
            let accelerated = self.measure(&self.scene(text, 10, 30, true)?, Schedule::Fused, true)?;
            Ok(TableRow { law, plain, accelerated })
        };
        LAWS.into_iter().map(row).collect()
    }

    /// Figure 5: 500 steps in 50 segments over so many spheres, without acceleration and with it.
    pub fn figure(&self, spheres: &[usize]) -> Result<Vec<(usize, Sample, Sample)>, RenderError> {
        let point = |&n: &usize| {
            let plain = self.measure(&self.scene(LAWS[3].1, n, 50, false)?, Schedule::Fused, false)?;
            let accelerated = self.measure(&self.scene(LAWS[3].1, n, 50, true)?, Schedule::Fused, true)?;
            Ok((n, plain, accelerated))
        };
        spheres.iter().map(point).collect()
    }

    /// The median time of a few renders, after one that compiles.
    fn measure(&self, scene: &Scene, schedule: Schedule, masks: bool) -> Result<Sample, RenderError> {
        let choice = Choice { schedule, masks, purpose: Purpose::Picture, layers: Vec::new() };
        let renderer = Renderer::new(self.gpu, scene, Settings { choice, ..Settings::default() })?;
        let mut samples = Vec::new();
        for _ in 0..=self.repeats {
            let totals = renderer.picture()?.totals;
            let advance = totals.device.map_or(totals.wall, |[_, advance, _, _]| advance);
            // Without masks every ray takes every step, though only those of living rays are kept and counted.
            let [width, height] = scene.image.size.map(u64::from);
            let every = width * height * u64::from(scene.rays.max_segments) * 10;
            samples.push(Sample { advance, ray_steps: if masks { totals.steps } else { every } });
        }
        let measured = &mut samples[1..];
        measured.sort_by_key(|sample| sample.advance);
        Ok(measured[measured.len() / 2])
    }

    fn scene(&self, law: &str, spheres: usize, segments: usize, accelerated: bool) -> Result<Scene, RenderError> {
        let [width, height] = self.size;
        let method = if accelerated {
            "method = \"euler-doubling\"\ndoubling = \"paper\"\ntolerance = 1e-3".to_owned()
        } else {
            format!("method = \"euler\"\nstep = {STEP}")
        };
        let mut text = format!(
            "[image]\nsize = [{width}, {height}]\n[camera]\nposition = [0, 0, 20]\n\
             [law]\n{law}\n[rays]\n{method}\nsegment = \"chord\"\nsteps_per_segment = 10\nmax_segments = {segments}\n\
             bound = {{ radius = 25 }}\n[sky]\ncolor = [0.1, 0.1, 0.2]\n\
             [materials.red]\ndiffuse = [0.8, 0.1, 0.1]\n[[lights]]\nkind = \"point\"\nposition = [10, 10, 20]\n"
        );
        for i in 0..spheres {
            // On a ring behind the hole, in turns nearer and further.
            let angle = std::f64::consts::TAU * i as f64 / spheres as f64;
            let (x, y, z) = (7.0 * angle.cos(), 5.0 * angle.sin(), if i % 2 == 0 { -6.0 } else { 2.0 });
            // Writing to a String cannot fail.
            let _ = write!(
                text,
                "[[objects]]\nshape = \"sphere\"\ncenter = [{x}, {y}, {z}]\nradius = 0.9\nmaterial = \"red\"\n"
            );
        }
        Scene::parse(&text, std::path::Path::new("bench"), &[]).map_err(own_scene)
    }
}

/// A mistake in a scene of our own.
fn own_scene(error: SceneError) -> RenderError {
    RenderError::Output(Box::new(error))
}
