//! The edge of a black hole's shadow as a method computes it.

use super::own_scene;
use crate::gpu::Gpu;
use crate::render::{RenderError, RenderSettings, Status, trace};

/// The critical impact parameter of the photon sphere: √27 M.
pub const CRITICAL: f64 = 5.196_152_422_706_632;

/// Returns the largest impact parameter b = L/E, for M = 1, with which a ray from r = 50 is captured under the given `[rays]` keys, or
/// `None` if no tried ray is captured.
///
/// # Errors
///
/// Returns [`RenderError::Output`] if `rays` is not valid, or another error if the device fails.
pub fn shadow_edge(gpu: &Gpu, rays: &str) -> Result<Option<f64>, RenderError> {
    let text = format!(
        "[law]\nkind = \"schwarzschild\"\nform = \"geodesic\"\n[rays]\n{rays}\nmax_segments = 20000\nbounding_sphere = {{ radius = 50 }}\n"
    );
    let scene = own_scene(&text)?;
    let impact: Vec<f64> = (0..2000).map(|i| 0.01 * f64::from(i)).collect();
    let starts: Vec<[f64; 6]> = impact.iter().map(|b| ray(50.0, *b)).collect();
    let (ends, _) = trace(gpu, &scene, &RenderSettings::default(), &starts)?;
    let captured = impact.iter().zip(&ends).filter(|(_, end)| end.status == Status::Captured).map(|(b, _)| *b);
    Ok(captured.fold(None, |most: Option<f64>, b| Some(most.map_or(b, |most| most.max(b)))))
}

/// Returns a ray from (r, 0, 0) inwards with impact parameter b = L/E: for a unit coordinate direction with the transverse component s, L =
/// r s and E² = 1 − s² + (1 − 2/r) s².
fn ray(r: f64, b: f64) -> [f64; 6] {
    let s = (b * b / (r * r + 2.0 * b * b / r)).sqrt();
    [r, 0.0, 0.0, -(1.0 - s * s).sqrt(), s, 0.0]
}
