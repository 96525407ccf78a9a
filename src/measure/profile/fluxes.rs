//! The sums over all emissions: the flux of a line by g, by time, and by frequency.

use std::convert::Infallible;

use rayon::prelude::*;

use super::Emission;
use crate::assets::Emissivity;
use crate::document::C;
use crate::program::CROSSINGS;

/// A value at each point of a profile, separately for each order.
pub type Orders = [f64; CROSSINGS];

/// The position of an emission at which an emissivity has no valid value: r, φ, t and μ, and the value.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("the emissivity is {value} at r = {}, phi = {}, t = {}, mu = {}; it must be finite and not negative", .place[0], .place[1], .place[2], .place[3])]
pub struct InvalidEmissivity {
    /// r, φ, t and μ.
    pub place: [f64; 4],
    /// The value.
    pub value: f64,
}

/// Returns the flux of a spectral line in each of `count` intervals of g from `range[0]` to `range[1]`, divided by the length of an
/// interval. Without a range, the intervals span all g of light. The second value is the range.
///
/// # Errors
///
/// Returns [`InvalidEmissivity`] if the emissivity is not a number from 0 at a crossing.
pub fn line(
    emissions: &[Emission],
    emissivity: &Emissivity,
    range: Option<[f64; 2]>,
    count: usize,
) -> Result<(Vec<Orders>, [f64; 2]), InvalidEmissivity> {
    let ends = |e: &Emission| [e.g - 0.5 * e.width, e.g + 0.5 * e.width];
    let all =
        emissions.iter().map(ends).fold([f64::INFINITY, 0.0], |all, one| [all[0].min(one[0]), all[1].max(one[1])]);
    let [low, high] = range.unwrap_or(if all[0] < all[1] { all } else { [0.0, 1.0] });
    let per_bin = (high - low) / count as f64;
    let profile = sums(emissions, count, |e, bins| {
        let light = e.weight * e.g.powi(4) * valid(emissivity, e, -e.time)?;
        let [start, end] = ends(e).map(|g| (g - low) / per_bin);
        let last = (end.ceil() as usize).max(start.floor() as usize + 1).min(count);
        for (bin, sum) in bins.iter_mut().enumerate().take(last).skip(start.max(0.0) as usize) {
            let [from, to] = [bin as f64, bin as f64 + 1.0];
            let inside = end.min(to) - start.max(from);
            let part =
                if end > start { inside.max(0.0) / (end - start) } else { f64::from(start >= from && start < to) };
            sum[e.order] += light * part / per_bin;
        }
        Ok(())
    })?;
    Ok((profile, [low, high]))
}

/// Returns the flux over all frequencies at each of these times of the observer. The emissivity sees the time at which the light left.
///
/// # Errors
///
/// Returns [`InvalidEmissivity`] if the emissivity is not a number from 0 at a crossing.
pub fn light_curve(
    emissions: &[Emission],
    emissivity: &Emissivity,
    times: &[f64],
) -> Result<Vec<Orders>, InvalidEmissivity> {
    sums(emissions, times.len(), |e, bins| {
        let light = e.weight * e.g.powi(4);
        for (t, sum) in times.iter().zip(bins) {
            sum[e.order] += light * valid(emissivity, e, t - e.time)?;
        }
        Ok(())
    })
}

/// Returns the flux of the surfaces that radiate as black bodies per frequency, at each of these frequencies in hertz, in W m⁻² Hz⁻¹. A
/// shifted black body is one of g times the temperature.
#[must_use]
pub fn spectrum(emissions: &[Emission], frequencies: &[f64]) -> Vec<Orders> {
    let sums = sums(emissions, frequencies.len(), |e, bins| {
        if let Some(temperature) = e.temperature.map(|kelvin| e.g * kelvin).filter(|kelvin| *kelvin > 0.0) {
            for (frequency, sum) in frequencies.iter().zip(bins) {
                sum[e.order] += e.weight * planck(*frequency, temperature);
            }
        }
        Ok::<(), Infallible>(())
    });
    match sums {
        Ok(sums) => sums,
        Err(never) => match never {},
    }
}

/// Returns the spectral radiance of a black body, in W m⁻² Hz⁻¹ sr⁻¹.
#[must_use]
pub fn planck(frequency: f64, kelvin: f64) -> f64 {
    2.0 * H * frequency.powi(3) / (C * C) / (H * frequency / (K * kelvin)).exp_m1()
}

/// The constants of Planck and Boltzmann, in SI units.
pub(super) const H: f64 = 6.626_070_15e-34;
pub(super) const K: f64 = 1.380_649e-23;

/// Returns the emissivity at an emission.
fn valid(emissivity: &Emissivity, e: &Emission, t: f64) -> Result<f64, InvalidEmissivity> {
    let place = [e.radius, e.azimuth, t, e.mu];
    let value = emissivity.at(e.radius, e.azimuth, t, e.mu);
    if value.is_finite() && value >= 0.0 { Ok(value) } else { Err(InvalidEmissivity { place, value }) }
}

/// The number of emissions whose sums one thread computes. It does not depend on the number of threads, so neither does the rounding.
const PER_SUM: usize = 1 << 14;

/// Adds all emissions to `count` sums per order.
fn sums<E: Send>(
    emissions: &[Emission],
    count: usize,
    add: impl Fn(&Emission, &mut [Orders]) -> Result<(), E> + Sync,
) -> Result<Vec<Orders>, E> {
    let of_part = |part: &[Emission]| {
        let mut sums = vec![Orders::default(); count];
        part.iter().try_for_each(|e| add(e, &mut sums)).map(|()| sums)
    };
    let parts: Vec<Result<Vec<Orders>, E>> = emissions.par_chunks(PER_SUM).map(of_part).collect();
    let mut all = vec![Orders::default(); count];
    for part in parts {
        for (sum, more) in all.iter_mut().zip(part?) {
            (0..CROSSINGS).for_each(|order| sum[order] += more[order]);
        }
    }
    Ok(all)
}
