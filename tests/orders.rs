//! Convergence of whole paths: the order of every method on several laws in 64 bits, and the limit by rounding in 32.
//!
//! The reference is a much finer solution by separate code on the CPU, in f64. A law whose device form had fewer digits
//! than f64 would therefore be detected too.

use bentray::gpu::Gpu;
use bentray::render::{RenderSettings, Status, Traced, trace};
use glam::DVec3;

use crate::shaders::schemes::{DORMAND_PRINCE, Phase, lorenz_field, path_rate};
use crate::support::{gpu, scene};

/// A law, its rate, the starts of rays, and the τ at which they end.
struct Law {
    name: &'static str,
    text: &'static str,
    rate: fn(Phase) -> Phase,
    second_order: bool,
    starts: fn(f64) -> Phase,
    length: f64,
}

/// Starts are exact in f32, so that 32 bits start from the same position.
const LAWS: [Law; 4] = [
    Law {
        name: "schwarzschild",
        text: "kind = \"schwarzschild\"",
        rate: path_rate,
        second_order: true,
        starts: |k| [DVec3::new(-12.0, 6.25 + 0.5 * k, 1.0), DVec3::X],
        length: 24.0,
    },
    Law {
        name: "inverse-square",
        text: "kind = \"sources\"\nsources = [{ position = [0, 0, 0], strength = 1.5 }]",
        rate: |p| [p[1], -1.5 / p[0].length().powi(3) * p[0]],
        second_order: true,
        starts: |k| [DVec3::new(-6.0, 2.0 + 0.25 * k, 0.5), DVec3::X],
        length: 12.0,
    },
    Law {
        name: "lorenz",
        text: "kind = \"lorenz\"\nbeta = 2.6666667461395264",
        rate: |p| [lorenz_field(p[0]), DVec3::ZERO],
        second_order: false,
        starts: |k| [DVec3::new(1.0 + k, 2.0 - k, 20.0), DVec3::X],
        length: 0.5,
    },
    Law {
        name: "lorenz, order 2",
        text: "kind = \"lorenz\"\nbeta = 2.6666667461395264\norder = 2",
        rate: |p| [p[1], lorenz_field(p[0])],
        second_order: true,
        starts: |k| [DVec3::new(1.0 + k, 2.0 - k, 20.0), DVec3::X],
        length: 1.0,
    },
];

const RAYS: u8 = 8;

impl Law {
    fn starts(&self) -> impl Iterator<Item = Phase> {
        (0..RAYS).map(|k| (self.starts)(f64::from(k)))
    }

    /// Returns the ends of the rays, by steps so small that the error is only rounding.
    fn truth(&self) -> Vec<DVec3> {
        const STEPS: u32 = 2000;
        let h = self.length / f64::from(STEPS);
        self.starts().map(|start| (0..STEPS).fold(start, |p, _| DORMAND_PRINCE.end(self.rate, p, h))[0]).collect()
    }

    /// Returns the ends of the rays on the device.
    fn ends(&self, gpu: &Gpu, precision: &str, rays: &str, segments: u32) -> Vec<Traced> {
        let text = format!(
            "[law]\n{}\n[rays]\nprecision = \"{precision}\"\nmax_parameter = {:?}\nmax_segments = {segments}\n{rays}\n\
             bounding_sphere = {{ radius = 1e4 }}\n",
            self.text, self.length
        );
        let starts: Vec<[f64; 6]> = self.starts().map(|[x, v]| [x.x, x.y, x.z, v.x, v.y, v.z]).collect();
        let (ends, _) = trace(gpu, &scene(&text), &RenderSettings::default(), &starts).unwrap();
        for end in &ends {
            assert_eq!(end.status, Status::Ended, "{} with {rays}", self.name);
            assert!((end.tau / self.length - 1.0).abs() < 1e-6, "{} with {rays} ends at {}", self.name, end.tau);
        }
        ends
    }

    /// Traces with `steps` steps of one size; the cap is far larger.
    fn fixed(&self, gpu: &Gpu, precision: &str, method: &str, steps: u32) -> Vec<Traced> {
        let h = self.length / f64::from(steps);
        let ends =
            self.ends(gpu, precision, &format!("method = \"{method}\"\nstep = {h:?}\nscaled_step = 1e6"), steps + 2);
        assert!(ends.iter().all(|end| end.steps.abs_diff(steps) <= 1), "the cap shortens steps");
        ends
    }

    fn embedded(&self, gpu: &Gpu, precision: &str, method: &str, tolerance: f64) -> Vec<Traced> {
        let rays = format!("method = \"{method}\"\ntolerance = {tolerance:e}\nscaled_step = 4.0");
        self.ends(gpu, precision, &rays, 8000)
    }
}

/// Returns the geometric mean of the relative errors of positions.
fn error(ends: &[Traced], truth: &[DVec3]) -> f64 {
    let logs = ends.iter().zip(truth).map(|(end, x)| (DVec3::from(end.x).distance(*x) / x.length()).max(1e-18).ln());
    (logs.sum::<f64>() / ends.len() as f64).exp()
}

/// Returns the slope of ln y over ln x by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let (mx, my) = logs.iter().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / n, b + y / n));
    let (xy, xx) = logs.iter().fold((0.0, 0.0), |(a, b), (x, y)| (a + (x - mx) * (y - my), b + (x - mx).powi(2)));
    xy / xx
}

/// Methods of fixed steps, their orders, whether they need an acceleration, and numbers of steps that reveal the order.
const FIXED: [(&str, f64, bool, [u32; 3]); 4] = [
    ("euler", 1.0, false, [2000, 4000, 8000]),
    ("leapfrog", 2.0, true, [200, 400, 800]),
    ("rkn4", 4.0, true, [200, 400, 800]),
    ("rk4", 4.0, false, [200, 400, 800]),
];

#[test]
fn fixed_steps_converge_by_their_order() {
    let gpu = gpu();
    for law in &LAWS {
        let truth = law.truth();
        for (method, order, needs_acceleration, counts) in FIXED {
            if needs_acceleration && !law.second_order {
                continue;
            }
            let points = counts.map(|n| (f64::from(n), error(&law.fixed(&gpu, "f64", method, n), &truth)));
            let observed = -slope(&points);
            println!("{}, {method}: order {observed:.3}, errors {:.1e} to {:.1e}", law.name, points[0].1, points[2].1);
            assert!((observed - order).abs() < 0.1, "{}, {method}: order {observed}", law.name);
        }
    }
}

/// Embedded pairs, their orders, and tolerances that reveal them: at larger ones Dormand–Prince takes only a few steps.
const EMBEDDED: [(&str, f64, [f64; 2]); 2] =
    [("bogacki-shampine", 3.0, [1e-6, 1e-8]), ("dormand-prince", 5.0, [1e-9, 1e-11])];

/// The step size is that whose estimate equals the tolerance, h ∝ tolerance^(1/p), so that the error is proportional to the
/// tolerance, and to steps^−p with the number of steps.
#[test]
fn embedded_pairs_converge_with_their_tolerance() {
    let gpu = gpu();
    for law in &LAWS {
        let truth = law.truth();
        for (method, order, tolerances) in EMBEDDED {
            let runs = tolerances.map(|tolerance| {
                let ends = law.embedded(&gpu, "f64", method, tolerance);
                let steps = ends.iter().map(|end| f64::from(end.steps)).sum::<f64>() / ends.len() as f64;
                (tolerance, steps, error(&ends, &truth))
            });
            let fall = slope(&runs.map(|(tolerance, _, error)| (tolerance, error)));
            let observed = -slope(&runs.map(|(_, steps, error)| (steps, error)));
            let [first, last] = runs.map(|(_, steps, error)| format!("{error:.1e} in {steps:.0} steps"));
            println!("{}, {method}: tolerance^{fall:.2}, order {observed:.2}, {first} to {last}", law.name);
            assert!((fall - 1.0).abs() < 0.1, "{}, {method}: as tolerance^{fall}", law.name);
            assert!((observed - order).abs() < 0.1 * order, "{}, {method}: order {observed}", law.name);
            // The accuracy that a ray is promised: the error is within the tolerance times its length.
            assert!(runs.iter().all(|(tolerance, _, error)| error < &(100.0 * tolerance)), "{}, {method}", law.name);
        }
    }
}

/// In 32 bits rounding limits the error, with more steps sooner; in 64 bits it continues to fall, as the other tests show.
#[test]
fn rounding_ends_the_fall() {
    let gpu = gpu();
    for law in &LAWS {
        let truth = law.truth();
        let least = |errors: [f64; 3]| errors.into_iter().fold(f64::INFINITY, f64::min);
        let fixed = [50, 100, 200].map(|steps| error(&law.fixed(&gpu, "f32", "rk4", steps), &truth));
        let embedded = [1e-6, 1e-7, 1e-8].map(|t| error(&law.embedded(&gpu, "f32", "dormand-prince", t), &truth));
        for (method, errors) in [("rk4", fixed), ("dormand-prince", embedded)] {
            println!("{}, {method}: {:.1e} at the least in f32", law.name, least(errors));
            assert!(least(errors) > 1e-9 && least(errors) < 1e-4, "{}, {method}: {errors:?} in 32 bits", law.name);
        }
    }
}
