//! Tests of the constants of motion of laws, with an independent implementation of the acceleration.

use super::*;
use crate::model::falloff::Falloff;
use crate::model::medium::{Fisheye, Sech};
use crate::model::{Anchor, Source};

/// Checks that constants of motion change by the square of a tiny step along the law's motion.
#[test]
fn invariants_are_kept() {
    let source = |position, strength, falloff: Option<Falloff>| {
        let falloff = falloff.expect("a falloff");
        Source { anchor: Anchor::center(position), strength, falloff, capture: 0.0 }
    };
    let laws: [Arc<dyn Law>; 6] = [
        Arc::new(Straight),
        Arc::new(RoundHole::new(1.3, DVec3::X)),
        Arc::new(Sources(vec![source(DVec3::Y, 2.0, Falloff::named("yukawa", 0.7))])),
        Arc::new(Sources(vec![
            source(DVec3::Y, -2.0, Some(Falloff::INVERSE_SQUARE)),
            source(DVec3::Z, 1.5, Falloff::named("cubic", 9.0)),
        ])),
        Arc::new(InMedium(Arc::new(Fisheye { center: DVec3::X, n0: 2.0, a: 4.0 }))),
        Arc::new(InMedium(Arc::new(Sech { origin: DVec3::Y, up: DVec3::Z, n0: 1.5, g: 0.3 }))),
    ];
    let x = DVec3::new(3.0, -2.0, 4.0);
    for law in &laws {
        let v = law.starting_velocity(x, DVec3::new(-0.5, 0.7, 0.4));
        let a = acceleration(&**law, x, v);
        let change = |h: f64| {
            let moved = law.invariants(x + h * v + 0.5 * h * h * a, v + h * a);
            let pairs = law.invariants(x, v).into_iter().zip(moved);
            pairs.map(|(a, b)| (a.value - b.value).abs()).fold(0.0, f64::max)
        };
        assert!(!law.invariants(x, v).is_empty());
        let (large, small) = (change(1e-3), change(1e-4));
        assert!(large < 1e-5 && small <= 0.02 * large + 1e-14, "{law:?}: {large:e}, {small:e}");
    }
}

fn acceleration(law: &dyn Law, x: DVec3, v: DVec3) -> DVec3 {
    if let Some(RoundHole { mass, center, .. }) = law.downcast() {
        let d = x - *center;
        -3.0 * mass * d.cross(v).length_squared() / d.length().powi(5) * d
    } else if let Some(Sources(sources)) = law.downcast() {
        sources.iter().map(|source| pull(source, x)).sum()
    } else if let Some(InMedium(medium)) = law.downcast() {
        // The derivative of n²/2; its error of about 1e-10 is far below the tolerance.
        let half_square = |x: DVec3| 0.5 * medium.index(x).unwrap().powi(2);
        let slope = |axis: DVec3| (half_square(x + 1e-5 * axis) - half_square(x - 1e-5 * axis)) / 2e-5;
        DVec3::from_array(DVec3::AXES.map(slope))
    } else {
        DVec3::ZERO
    }
}

fn pull(source: &Source, x: DVec3) -> DVec3 {
    let d = x - source.anchor.position;
    let (r, parameter) = (d.length(), source.falloff.parameter);
    let strength = match source.falloff.kind.name {
        "inverse-square" => 1.0 / (r * r),
        "yukawa" => (-parameter * r).exp() * (1.0 + parameter * r) / (r * r),
        "cubic" => 2.0 * (r / parameter).powi(3) - 3.0 * (r / parameter).powi(2) + 1.0,
        other => panic!("no force is known for {other}"),
    };
    -source.strength * strength / r * d
}
