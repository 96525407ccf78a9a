//! Tabulates the colors of black bodies and the orbits of emitting matter.

use crate::model::{Binding, Law, black_body, matter, row};
use crate::program::constant;

/// Returns the colors of black bodies.
pub(super) fn black_bodies() -> Binding {
    let coolest = constant("surface/black_body", "COOLEST");
    let hottest = constant("surface/black_body", "HOTTEST");
    let count = constant("surface/black_body", "TEMPERATURES");
    let row = |i: u32| {
        let (color, luminance) = black_body::color(coolest * (hottest / coolest).powf(f64::from(i) / (count - 1.0)));
        row! { color: Vec3(color), luminance: Float(luminance) }
    };
    Binding::list("black_bodies", (0..count as u32).map(row).collect())
}

/// Returns the circular orbits of matter around the axis of a law, if the law has any.
pub(super) fn orbits(law: &dyn Law, outer: f64) -> Option<[Binding; 2]> {
    let [center, axis] = law.equator()?;
    let count = constant("surface/material/accretion", "ORBITS") as usize;
    let (_, orbits) = matter::orbits(law, outer, count)?;
    let most = orbits.iter().map(|orbit| orbit.flux).fold(0.0, f64::max);
    let row = |orbit: &matter::Orbit| row! { u: Vec3(orbit.u), light: Float((orbit.flux / most).max(0.0).sqrt()) };
    let [first, second] = [orbits[0].rho.ln(), orbits[1].rho.ln()];
    let equator =
        row! { center: Vec3(center), first: Float(first), axis: Vec3(axis), per_orbit: Float(second - first) };
    Some([Binding::one("equator", equator), Binding::list("orbits", orbits.iter().map(row).collect())])
}
