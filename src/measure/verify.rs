//! The error of an image, measured on some of its rays.

use std::fmt;

use super::{ErrorStats, Quantiles, ReferenceSolution, scattered};
use crate::gpu::Gpu;
use crate::render::{RenderError, RenderSettings, Starts, Tracer};
use crate::scene::Scene;

/// The error of a scene's image.
#[derive(Debug, Clone, PartialEq)]
pub struct Verification {
    /// The errors of the rays that were followed again.
    pub found: ErrorStats,
    /// The tolerance of the reference solution.
    pub tolerance: f64,
}

/// A seed for pixels that differ from those of a calibration.
const VERIFIED: u64 = 2;
/// The loosest tolerance of a reference solution, which costs little compared with the image.
const LOOSEST: f64 = 1e-10;
/// The number of pixels in a row of the list.
const PIXELS_A_ROW: u32 = 1024;

/// Measures the error of an image: follows the rays of `count` random pixels (of their first sample) as the image does, and again in 64
/// bits.
///
/// The pixels are the same in every run; if the image has fewer, all are used. If `gpu` has no 64-bit floats, the first other device that
/// supports them computes the reference solution.
///
/// # Errors
///
/// Returns [`GpuError::NoDouble`](crate::gpu::GpuError::NoDouble) if no device supports 64 bits, and the errors of [`Tracer::new`].
///
/// # Examples
///
/// ```no_run
/// use bentray::{gpu::Gpu, measure::verify, render::RenderSettings, scene::Scene};
///
/// let scene = Scene::load("scenes/black_hole.toml".as_ref(), &["rays.method=rk4".parse()?])?;
/// let found = verify(&Gpu::open(None)?, &scene, &RenderSettings::default(), 1000)?.found;
/// println!("99 % of the directions are within {:.1e} rad", found.angle.p99);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn verify(gpu: &Gpu, scene: &Scene, settings: &RenderSettings, count: usize) -> Result<Verification, RenderError> {
    let _stage = gpu.progress.stage("verifying");
    let pixels = scattered(scene.image.size, count, VERIFIED);
    let starts = Starts::Pixels(&pixels, PIXELS_A_ROW);
    let mut tracer = Tracer::new(gpu, scene, settings.clone(), starts.mode())?;
    let (rays, _) = tracer.follow(starts)?;
    let own = scene.rays.control.tolerance().unwrap_or(LOOSEST);
    let tolerance = (own / 1000.0).clamp(1e-13, LOOSEST);
    let truth = ReferenceSolution::new(gpu, scene, tolerance, starts)?;
    Ok(Verification { found: ErrorStats::new(&rays, tracer.spectra(), &truth), tolerance })
}

impl Verification {
    /// Returns (key, value) pairs for an image's metadata.
    #[must_use]
    pub fn metadata(&self) -> Vec<(String, String)> {
        let found = &self.found;
        let quantiles = |q: &Quantiles| {
            if q.max.is_nan() {
                return "none: no ray could be compared".to_owned();
            }
            format!("median {:.2e}, 99% {:.2e}, max {:.2e}", q.median, q.p99, q.max)
        };
        let rows = [
            ("rays", found.rays.to_string()),
            ("tolerance of the reference", format!("{:.0e}", self.tolerance)),
            ("angle error (rad)", quantiles(&found.angle)),
            ("position error", quantiles(&found.position)),
            ("tau error", quantiles(&found.tau)),
            ("wrong ends", found.wrong.to_string()),
            ("unresolved", found.unresolved.to_string()),
        ];
        let light = found.light.as_ref().map(|light| ("intensity error, relative", quantiles(light)));
        rows.into_iter().chain(light).map(|(key, value)| (format!("verify: {key}"), value)).collect()
    }
}

impl fmt::Display for Verification {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let found = &self.found;
        if found.rays == 0 {
            return write!(
                f,
                "not verified: none of {} rays has a resolved end in the reference solution (f64, tolerance {:.0e})",
                found.unresolved, self.tolerance
            );
        }
        writeln!(
            f,
            "verified {} rays against a reference solution (f64, tolerance {:.0e}): {} with a wrong end ({} of them \
             flagged), {} unresolved",
            found.rays, self.tolerance, found.wrong, found.flagged, found.unresolved
        )?;
        writeln!(f, "{:<22}{:>12}{:>12}{:>12}", "error", "median", "99 %", "max")?;
        let rows = [("angle (rad)", &found.angle), ("position", &found.position), ("τ", &found.tau)];
        let light = found.light.as_ref().map(|light| ("intensity, relative", light));
        let lines: Vec<_> = rows.into_iter().chain(light).map(|(name, q)| format!("{name:<22}{q}")).collect();
        f.write_str(&lines.join("\n"))
    }
}
