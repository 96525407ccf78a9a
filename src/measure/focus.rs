//! The focus of a ray bundle, where its paths are closest together.
//!
//! *Theory.* The spread of a bundle at a point p is the root mean square of the distances from p to its paths. It is minimal at a focus.
//! For straight lines this is the solution of 3 × 3 equations, Σ (1 − d dᵀ)(p − x) = 0. For curves this step is iterated with the tangents
//! at the nearest points (Gauss–Newton).
//!
//! *Practice.* The spread of a fan is least at its start, so that a search needs an initial point: along some of the paths, the point at
//! which the spread has decreased most from an earlier value. If the spread only grows, or still decreases at the ends of the paths, the
//! last segments are extended as straight lines in both directions, because a diverging lens has its focus before it.

use glam::{DMat3, DVec3};

use super::Curve;

/// The number of paths along which the search looks for an initial point.
const GUIDES: usize = 9;
/// The number of paths whose distances the search computes.
const COMPARED: usize = 40;
/// The number of points per path in the search.
const POINTS: usize = 300;
/// The ratio to an earlier spread below which the spread has decreased; the spread of parallel rays fluctuates.
const FALLEN: f64 = 0.9;
/// The mean square difference of directions below which lines are parallel.
const PARALLEL: f64 = 1e-9;
/// The number of iterations of the final search.
const ROUNDS: usize = 100;

/// A focus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Focus {
    /// The position in scene coordinates.
    pub place: DVec3,
    /// The root mean square of the distances of rays.
    pub spread: f64,
    /// Is `true` for a real focus, and `false` if only the straight extensions of the paths reach it.
    pub real: bool,
}

/// A point of a path with the unit direction of the path there.
type Tangent = (DVec3, DVec3);

/// Returns the point behind their starts where these paths are closest together, or `None` for fewer than two paths or parallel rays.
#[must_use]
pub fn focus(curves: &[Curve]) -> Option<Focus> {
    let paths: Vec<Vec<DVec3>> = curves.iter().map(Curve::flattened).filter(|path| path.len() > 1).collect();
    let lasts: Vec<Tangent> = paths.iter().filter_map(|path| tangent(path, path.len() - 2, 1.0)).collect();
    if paths.len() < 2 {
        return None;
    }
    let beyond = meeting(&lasts).map(|place| Focus { place, spread: root_mean_square(&lasts, place), real: false });
    let Some((start, at_end)) = deepest(&paths) else { return beyond };
    let found = refined(&paths, start);
    // Rays that still converge at their ends meet beyond them.
    match beyond {
        Some(beyond) if at_end && beyond.spread < 0.5 * found.spread => Some(beyond),
        _ => Some(found),
    }
}

/// Returns the point of the greatest decrease of the spread along some of the paths, and `true` if it is the end of a path.
fn deepest(paths: &[Vec<DVec3>]) -> Option<(DVec3, bool)> {
    let thinned: Vec<Vec<DVec3>> = evenly(paths, COMPARED).map(|path| resampled(path)).collect();
    let mut best: Option<(f64, DVec3, bool)> = None;
    for guide in evenly(&thinned, GUIDES) {
        let mut highest = 0.0_f64;
        for (i, &p) in guide.iter().enumerate() {
            let spread = spread(&thinned, p);
            if spread < FALLEN * highest && best.is_none_or(|(least, ..)| spread < least) {
                best = Some((spread, p, i + 1 == guide.len()));
            }
            highest = highest.max(spread);
        }
    }
    best.map(|(_, place, at_end)| (place, at_end))
}

/// Iterates Gauss–Newton steps from a point as long as the spread decreases.
fn refined(paths: &[Vec<DVec3>], start: DVec3) -> Focus {
    let mut focus = Focus { place: start, spread: spread(paths, start), real: true };
    for _ in 0..ROUNDS {
        let nearest: Vec<Tangent> = paths.iter().filter_map(|path| nearest(path, focus.place)).collect();
        let Some(place) = meeting(&nearest) else { break };
        let spread = spread(paths, place);
        if spread >= focus.spread {
            break;
        }
        focus = Focus { place, spread, real: true };
    }
    focus
}

/// Returns `count` evenly spaced items, from first to last.
fn evenly<T>(items: &[T], count: usize) -> impl Iterator<Item = &T> {
    let kept = count.min(items.len());
    (0..kept).map(move |i| &items[if kept == 1 { 0 } else { i * (items.len() - 1) / (kept - 1) }])
}

/// Returns equidistant points along a path, including its ends, regardless of the number and length of segments.
fn resampled(path: &[DVec3]) -> Vec<DVec3> {
    let length: f64 = path.windows(2).map(|ends| ends[0].distance(ends[1])).sum();
    let step = length / POINTS as f64;
    let mut points = vec![path[0]];
    let mut passed = 0.0;
    for ends in path.windows(2) {
        let piece = ends[0].distance(ends[1]);
        while points.len() < POINTS && points.len() as f64 * step <= passed + piece {
            points.push(ends[0].lerp(ends[1], (points.len() as f64 * step - passed) / piece));
        }
        passed += piece;
    }
    points.extend(path.last());
    points
}

fn spread(paths: &[Vec<DVec3>], p: DVec3) -> f64 {
    let squares = paths.iter().filter_map(|path| nearest(path, p)).map(|(q, _)| q.distance_squared(p));
    (squares.sum::<f64>() / paths.len() as f64).sqrt()
}

/// Returns the point of a path nearest to p.
fn nearest(path: &[DVec3], p: DVec3) -> Option<Tangent> {
    let place = |i: usize| {
        let along = path[i + 1] - path[i];
        let length = along.length_squared();
        let t = if length > 0.0 { ((p - path[i]).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
        (i, t, (path[i] + t * along).distance_squared(p))
    };
    let (i, t, _) = (0..path.len() - 1).map(place).min_by(|a, b| a.2.total_cmp(&b.2))?;
    tangent(path, i, t)
}

fn tangent(path: &[DVec3], i: usize, t: f64) -> Option<Tangent> {
    Some((path[i].lerp(path[i + 1], t), (path[i + 1] - path[i]).try_normalize()?))
}

/// Returns the least-squares intersection of lines, or `None` if they are parallel.
fn meeting(lines: &[Tangent]) -> Option<DVec3> {
    let across = |d: DVec3| DMat3::IDENTITY - DMat3::from_cols(d * d.x, d * d.y, d * d.z);
    let count = lines.len().max(1) as f64;
    let middle = lines.iter().map(|(x, _)| *x).sum::<DVec3>() / count;
    let matrix = lines.iter().fold(DMat3::ZERO, |sum, (_, d)| sum + across(*d)) * (1.0 / count);
    let side = lines.iter().fold(DVec3::ZERO, |sum, (x, d)| sum + across(*d) * (*x - middle)) / count;
    // The least eigenvalue is the mean square deviation of the lines from a common direction; the others are near 1.
    (matrix.determinant() > PARALLEL).then(|| middle + matrix.inverse() * side)
}

fn root_mean_square(lines: &[Tangent], p: DVec3) -> f64 {
    let squares = lines.iter().map(|(x, d)| (p - *x).reject_from_normalized(*d).length_squared());
    (squares.sum::<f64>() / lines.len().max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(ends: impl Iterator<Item = [DVec3; 2]>) -> Vec<Curve> {
        ends.map(|ends| Curve::through(&ends)).collect()
    }

    /// Returns rays from x = −5 to x = 5 at heights y, which pass (2, 0, 0) with individual errors.
    fn through(error: f64) -> Vec<Curve> {
        lines((-4..=4).map(|i| {
            let slope = 0.1 * f64::from(i);
            let off = if i % 2 == 0 { error } else { -error };
            [-5.0, 5.0].map(|x| DVec3::new(x, slope * (x - 2.0) + off, 1.0))
        }))
    }

    #[test]
    fn rays_that_cross_have_their_focus_there() {
        let found = focus(&through(0.0)).unwrap();
        assert!(
            found.place.distance(DVec3::new(2.0, 0.0, 1.0)) < 1e-9 && found.spread < 1e-9 && found.real,
            "{found:?}"
        );
        // Nine lines y = s (x − 2) ± e: the analytic least-squares solution of Σ (y − s (x − 2) ∓ e)²/(1 + s²).
        let found = focus(&through(0.01)).unwrap();
        let spread = |p: DVec3| {
            let squares = (-4..=4).map(|i| {
                let slope = 0.1 * f64::from(i);
                let off = if i % 2 == 0 { 0.01 } else { -0.01 };
                (p.y - slope * (p.x - 2.0) - off).powi(2) / (1.0 + slope * slope)
            });
            (squares.sum::<f64>() / 9.0).sqrt()
        };
        assert!((found.spread - spread(found.place)).abs() < 1e-12);
        for step in [DVec3::X, -DVec3::X, DVec3::Y, -DVec3::Y] {
            assert!(spread(found.place + 1e-3 * step) > found.spread, "{found:?}");
        }
    }

    #[test]
    fn rays_that_spread_have_theirs_before_their_starts_and_converging_ones_behind_their_ends() {
        let part = |from: f64, to: f64| {
            lines(
                (-4..=4)
                    .map(|i| 0.1 * f64::from(i))
                    .map(|s| [from, to].map(|x| DVec3::new(x, 3.0 + s * (x - 2.0), 0.0))),
            )
        };
        for (from, to) in [(3.0, 5.0), (-4.0, 1.0)] {
            let found = focus(&part(from, to)).unwrap();
            assert!(!found.real && found.place.distance(DVec3::new(2.0, 3.0, 0.0)) < 1e-9, "{found:?}");
        }
    }

    #[test]
    fn a_fan_that_is_bent_back_has_its_focus_where_it_meets_again() {
        // Circles of one size from (−1, 0) through (1, 0), as in a Maxwell fisheye lens.
        let circles = (-4..=4).map(|i| 0.2 * f64::from(i)).map(|height| {
            // Around (0, h), by the angle from vertical, from −a to a; both ends are at y = 0.
            let radius = (1.0 + height * height).sqrt();
            let end = 1.0_f64.atan2(-height);
            let point = |k: i32| {
                let (sin, cos) = (end * (f64::from(k) / 100.0 - 1.0)).sin_cos();
                DVec3::new(radius * sin, height + radius * cos, 0.0)
            };
            Curve::through(&(0..240).map(point).collect::<Vec<_>>())
        });
        let found = focus(&circles.collect::<Vec<_>>()).unwrap();
        assert!(found.real && found.place.distance(DVec3::X) < 0.02 && found.spread < 0.02, "{found:?}");
    }

    #[test]
    fn parallel_rays_have_none() {
        let parallel =
            lines((0..5).map(|i| [-5.0, 5.0].map(|x| DVec3::new(x, f64::from(i) + 1e-7 * x * f64::from(i % 2), 0.0))));
        assert_eq!(focus(&parallel), None);
        assert_eq!(focus(&parallel[..1]), None);
        assert_eq!(focus(&[]), None);
    }
}
