//! Matter that cannot be as the formulas of a volume state, found at sample positions.

use glam::DVec3;

use super::{Scene, Volume};
use crate::assets::VolumeFormulas;
use crate::model::volume::Flow;

/// The number of positions in a volume.
const POSITIONS: u32 = 2048;
/// The powers of the inverse of 1.2207…, the root of x⁴ = x + 1: a low-discrepancy sequence in three dimensions.
const SEQUENCE: DVec3 = DVec3::new(0.819_172_513_396_164_5, 0.671_043_606_703_789_2, 0.549_700_477_901_970_2);

impl Scene {
    /// Returns a message with a position for each volume in which matter is negative, not a number or faster than light.
    pub(super) fn impossible_matter(&self) -> Vec<String> {
        let message = |(i, volume): (usize, &Volume)| {
            let (what, at) = self.positions(volume).find_map(|x| Some((self.impossible_at(volume, x)?, x)))?;
            Some(format!(
                "volumes[{i}]: {what} at [{:.3}, {:.3}, {:.3}], and rays through such matter show nothing: correct the formula, or let \
                 the density be 0 there",
                at.x, at.y, at.z
            ))
        };
        self.volumes.iter().enumerate().filter_map(message).collect()
    }

    /// Returns positions that are spread over the part of a volume that rays reach: in the bounding sphere, and outside the horizon.
    fn positions<'a>(&'a self, volume: &'a Volume) -> impl Iterator<Item = DVec3> + 'a {
        let bound = self.rays.bounding_sphere;
        let around = |center: DVec3, radius: f64| [center - radius, center + radius];
        let [lo, hi] = volume.bounds().unwrap_or_else(|| around(bound.center, bound.radius));
        let all = (1..=POSITIONS).map(move |i| lo + (hi - lo) * (f64::from(i) * SEQUENCE).fract());
        let outside = |x: &DVec3| self.horizon().is_none_or(|horizon| horizon.distance(*x) > 0.0);
        let is_reached = move |x: &DVec3| x.distance(bound.center) < bound.radius;
        all.filter(is_reached).filter(move |x| volume.contains(*x)).filter(outside)
    }

    /// Returns a problem of the matter of a volume at a position, if there is one.
    fn impossible_at(&self, volume: &Volume, x: DVec3) -> Option<String> {
        let formulas = &volume.formulas;
        let mut variables = self.formula_variables(volume, x)?;
        let density = formulas.values(&variables)[formulas.density.index()];
        let is_impossible = |value: f64| !(0.0..=f64::MAX).contains(&value);
        if is_impossible(density) {
            return Some(format!("the density is {density:.3}"));
        }
        if density == 0.0 {
            return None;
        }
        // The density is a variable of the formulas of light.
        variables[usize::from(VolumeFormulas::DENSITY.0)] = density;
        let values = formulas.values(&variables);
        let emissions = formulas.coefficients.iter().map(|channel| ("the emission", channel.emission));
        let absorptions = formulas.coefficients.iter().map(|channel| ("the absorption", channel.absorption));
        let temperature = formulas.temperature.map(|id| ("the temperature", id));
        let found = emissions.chain(absorptions).chain(temperature).find(|(_, id)| is_impossible(values[id.index()]));
        if let Some((name, id)) = found {
            return Some(format!("{name} is {:.3}", values[id.index()]));
        }
        let speed = formulas.flow.iter().map(|id| values[id.index()].powi(2)).sum::<f64>().sqrt();
        (volume.flow == Flow::Velocity && !(0.0..1.0).contains(&speed))
            .then(|| format!("the speed is {speed:.3} of that of light"))
    }

    /// Returns the variables of a volume's formulas at a position, with n = ν = 1; `None` if the law has its own coordinates without an
    /// equator.
    fn formula_variables(&self, volume: &Volume, x: DVec3) -> Option<Vec<f64>> {
        let (q, r) = if self.places_volumes_by_law() {
            let [center, _] = self.law.equator()?;
            (self.law.formula_axes().transpose() * (x - center), self.law.spherical(x)?.radius)
        } else {
            let q = x - volume.center();
            (q, q.length())
        };
        let time = self.camera.as_ref().map_or(0.0, |camera| camera.time);
        let cosine = (q.z / r).clamp(-1.0, 1.0);
        let place = [q.x, q.y, q.z, time, r, q.x.hypot(q.y), (1.0 - cosine * cosine).sqrt(), cosine, 1.0, 1.0];
        Some(place.into_iter().chain(volume.grids.iter().map(|grid| grid.value(q))).collect())
    }
}
