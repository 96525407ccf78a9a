//! The glare of a camera's lens, which spreads a part of all light: bright stars look larger.
//!
//! The kernel is a sum of seven bells of the widths σ = 0.001 · 2^k of the image's height and the weights 2^−k, so that glare falls nearly
//! with the third power of the distance. Each bell is three means over an interval (a B-spline), along rows and then along columns. The
//! kernel has the sum 1, and light that it spreads beyond the edges is lost.

use rayon::prelude::*;

use crate::render::Band;

/// The width σ of the narrowest bell, as a fraction of the image's height.
const NARROWEST: f64 = 1e-3;
/// The number of bells; each is twice as wide as the one before.
const BELLS: i32 = 7;

/// Spreads a fraction of the light of an image.
pub(super) fn spread(band: &mut Band, fraction: f64) {
    let (width, height) = (band.width as usize, band.rows as usize);
    let total: f64 = (0..BELLS).map(|k| 0.5_f64.powi(k)).sum();
    for plane in &mut band.color {
        // A color that is not finite would spread over the whole image.
        let sharp: Vec<f32> = plane.iter().map(|light| if light.is_finite() { *light } else { 0.0 }).collect();
        let kept = (1.0 - fraction) as f32;
        for light in plane.iter_mut() {
            *light *= kept;
        }
        for k in 0..BELLS {
            let sigma = NARROWEST * f64::from(1 << k) * height as f64;
            let weight = (fraction * 0.5_f64.powi(k) / total) as f32;
            let columns = turned(&bell(&sharp, width, sigma), width);
            let rows = turned(&bell(&columns, height, sigma), height);
            plane.iter_mut().zip(rows).for_each(|(light, spread)| *light += weight * spread);
        }
    }
}

/// Returns a plane with its rows as columns.
fn turned(plane: &[f32], width: usize) -> Vec<f32> {
    let height = plane.len() / width;
    (0..width).into_par_iter().flat_map_iter(|x| (0..height).map(move |y| plane[y * width + x])).collect()
}

/// Returns a plane whose rows are spread by a bell of the width σ, in pixels: three means over an interval.
fn bell(plane: &[f32], width: usize, sigma: f64) -> Vec<f32> {
    // The variance of a mean over an interval is a twelfth of its squared length.
    let half = 0.5 * (4.0 * sigma * sigma + 1.0).sqrt() - 0.5;
    let mut out = plane.to_vec();
    out.par_chunks_mut(width).for_each(|row| {
        let mut line: Vec<f64> = row.iter().map(|light| f64::from(*light)).collect();
        for _ in 0..3 {
            line = mean(&line, half);
        }
        row.iter_mut().zip(line).for_each(|(light, spread)| *light = spread as f32);
    });
    out
}

/// Returns the mean over the pixels up to `half` pixels away, with the fraction of `half` as the weight of the outermost ones.
fn mean(line: &[f64], half: f64) -> Vec<f64> {
    let (whole, part) = (half.floor() as usize, half.fract());
    // The sums before each pixel.
    let sums: Vec<f64> = std::iter::once(0.0)
        .chain(line.iter().scan(0.0, |sum, light| {
            *sum += light;
            Some(*sum)
        }))
        .collect();
    let at = |i: Option<usize>| i.and_then(|i| line.get(i)).copied().unwrap_or(0.0);
    let of = |i: usize| {
        let inside = sums[(i + whole + 1).min(line.len())] - sums[i.saturating_sub(whole)];
        let outermost = at(i.checked_sub(whole + 1)) + at(Some(i + whole + 1));
        (inside + part * outermost) / (2.0 * half + 1.0)
    };
    (0..line.len()).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lit(size: [u32; 2], at: [u32; 2], light: f32) -> Band {
        let mut plane = vec![0.0; (size[0] * size[1]) as usize];
        plane[(at[1] * size[0] + at[0]) as usize] = light;
        Band {
            first_row: 0,
            rows: size[1],
            width: size[0],
            color: [plane.clone(), plane.clone(), plane],
            alpha: None,
            layers: Vec::new(),
        }
    }

    #[test]
    fn light_is_spread_evenly_around_a_point_and_kept() {
        let (size, at) = ([601, 601], [300, 300]);
        let mut band = lit(size, at, 8.0);
        spread(&mut band, 0.25);
        let plane = &band.color[1];
        let of = |x: u32, y: u32| f64::from(plane[(y * size[0] + x) as usize]);
        let sum: f64 = plane.iter().map(|light| f64::from(*light)).sum();
        assert!((sum / 8.0 - 1.0).abs() < 1e-5, "{sum}");
        for r in 1..250 {
            assert!((of(300 + r, 300) - of(300, 300 - r)).abs() <= 1e-6 * of(300, 300), "{r}");
            assert!(of(300 + r, 300) <= of(299 + r, 300), "{r}");
        }
        // Second moments: three means have the variance σ² of their bell.
        let total: f64 = (0..BELLS).map(|k| 0.5_f64.powi(k)).sum();
        let bells = (0..BELLS).map(|k| 0.5_f64.powi(k) / total * (NARROWEST * f64::from(1 << k) * 601.0).powi(2));
        let expected = 0.25 * 2.0 * bells.sum::<f64>();
        let moment = |i: u32| f64::from(i).mul_add(1.0, -300.0).powi(2);
        let found: f64 = (0..601 * 601)
            .map(|i: u32| f64::from(plane[i as usize]) * (moment(i % 601) + moment(i / 601)))
            .sum::<f64>()
            / 8.0;
        assert!((found / expected - 1.0).abs() < 0.03, "{found} {expected}");
    }

    #[test]
    fn light_that_is_not_finite_stays_where_it_is() {
        let mut band = lit([20, 10], [3, 4], f32::INFINITY);
        spread(&mut band, 0.5);
        assert_eq!(band.color[0].iter().filter(|light| !light.is_finite()).count(), 1);
    }
}
