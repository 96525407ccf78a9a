//! Independent implementations of the methods over any kind of vector: exact ones, and ones with a bound on their rounding errors.

use glam::DVec3;

/// The operations that a method needs on positions and velocities.
pub trait Vector: Copy {
    /// Returns self + h Σ a k.
    fn plus(self, h: f64, terms: &[(f64, Self)]) -> Self;

    /// Returns h Σ a k.
    fn sum(h: f64, terms: &[(f64, Self)]) -> Self;
}

impl Vector for DVec3 {
    fn plus(self, h: f64, terms: &[(f64, Self)]) -> Self {
        self + Self::sum(h, terms)
    }

    fn sum(h: f64, terms: &[(f64, Self)]) -> Self {
        h * terms.iter().map(|(a, k)| *a * *k).sum::<Self>()
    }
}

pub type Phase = [DVec3; 2];

/// Returns the acceleration of the Schwarzschild path form around 0, M = 1, along a ray with the h² of p.
pub fn path_bend(p: Phase) -> impl Fn(DVec3) -> DVec3 {
    let held = p[0].cross(p[1]).length_squared();
    move |x| -3.0 * held / x.length().powi(5) * x
}

/// Returns the rate of the path form as a law of the first order.
pub fn path_rate(p: Phase) -> Phase {
    rate_of(path_bend, p)
}

/// Returns the Lorenz field with β = 8/3 in f32.
pub fn lorenz_field(x: DVec3) -> DVec3 {
    DVec3::new(10.0 * (x.y - x.x), 28.0 * x.x - x.y - x.x * x.z, x.x * x.y - f64::from(8.0_f32 / 3.0) * x.z)
}

/// Returns the rate of a law of the second order as one of the first.
pub fn rate_of<V: Vector, A: Fn(V) -> V>(bend: impl Fn([V; 2]) -> A, p: [V; 2]) -> [V; 2] {
    [p[1], bend(p)(p[0])]
}

fn columns<V: Vector>(p: [V; 2], h: f64, terms: &[(f64, [V; 2])]) -> [V; 2] {
    [0, 1].map(|i| p[i].plus(h, &terms.iter().map(|(a, k)| (*a, k[i])).collect::<Vec<_>>()))
}

pub fn euler<V: Vector>(rate: impl Fn([V; 2]) -> [V; 2], p: [V; 2], h: f64) -> [V; 2] {
    columns(p, h, &[(1.0, rate(p))])
}

pub fn rk4<V: Vector>(rate: impl Fn([V; 2]) -> [V; 2], p: [V; 2], h: f64) -> [V; 2] {
    let k1 = rate(p);
    let k2 = rate(columns(p, 0.5 * h, &[(1.0, k1)]));
    let k3 = rate(columns(p, 0.5 * h, &[(1.0, k2)]));
    let k4 = rate(columns(p, h, &[(1.0, k3)]));
    columns(p, h / 6.0, &[(1.0, k1), (2.0, k2), (2.0, k3), (1.0, k4)])
}

pub fn leapfrog<V: Vector, A: Fn(V) -> V>(bend: impl Fn([V; 2]) -> A, p: [V; 2], h: f64) -> [V; 2] {
    let middle = p[0].plus(0.5 * h, &[(1.0, p[1])]);
    let v = p[1].plus(h, &[(1.0, bend(p)(middle))]);
    [middle.plus(0.5 * h, &[(1.0, v)]), v]
}

/// Takes a Nyström step (Hairer, Nørsett, Wanner I, Table II.14.2): the positions of the stages of x″ = a(x), and the weights of x and v.
pub fn rkn4<V: Vector, A: Fn(V) -> V>(bend: impl Fn([V; 2]) -> A, p: [V; 2], h: f64) -> [V; 2] {
    let a = bend(p);
    let stage = |c: f64, coefficient: f64, k: V| p[0].plus(h, &[(c, p[1]), (coefficient * h, k)]);
    let k1 = a(p[0]);
    let k2 = a(stage(0.5, 0.125, k1));
    let k3 = a(stage(1.0, 0.5, k2));
    let x = p[0].plus(h, &[(1.0, p[1]), (h / 6.0, k1), (h / 3.0, k2)]);
    [x, p[1].plus(h, &[(1.0 / 6.0, k1), (2.0 / 3.0, k2), (1.0 / 6.0, k3)])]
}

/// An embedded pair whose last stage is its result: the coefficients of the stages, and the weights of the other result.
#[derive(Clone, Copy)]
pub struct Pair {
    pub stages: &'static [&'static [f64]],
    pub others: &'static [f64],
}

/// The Bogacki–Shampine pair, *A 3(2) pair of Runge–Kutta formulas* (1989).
pub const BOGACKI_SHAMPINE: Pair = Pair {
    stages: &[&[0.5], &[0.0, 0.75], &[2.0 / 9.0, 1.0 / 3.0, 4.0 / 9.0]],
    others: &[7.0 / 24.0, 1.0 / 4.0, 1.0 / 3.0, 1.0 / 8.0],
};

/// The Dormand–Prince pair (1980), as in Hairer, Nørsett, Wanner I, Table II.5.2.
pub const DORMAND_PRINCE: Pair = Pair {
    stages: &[
        &[1.0 / 5.0],
        &[3.0 / 40.0, 9.0 / 40.0],
        &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
        &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
        &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
        &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
    ],
    others: &[5179.0 / 57600.0, 0.0, 7571.0 / 16695.0, 393.0 / 640.0, -92097.0 / 339_200.0, 187.0 / 2100.0, 1.0 / 40.0],
};

impl Pair {
    /// Returns the end, the difference of the two results, and the rate at the end.
    pub fn step<V: Vector>(&self, rate: impl Fn([V; 2]) -> [V; 2], p: [V; 2], h: f64) -> [[V; 2]; 3] {
        let mut rates = vec![rate(p)];
        let mut end = p;
        for row in self.stages {
            let terms: Vec<_> = row.iter().copied().zip(rates.iter().copied()).filter(|(a, _)| *a != 0.0).collect();
            end = columns(p, h, &terms);
            rates.push(rate(end));
        }
        let last = self.stages.last().expect("stages").iter().copied().chain([0.0]);
        let weights: Vec<f64> = last.zip(self.others).map(|(a, b)| a - b).collect();
        let error = [0, 1].map(|i| {
            let terms: Vec<_> =
                weights.iter().zip(&rates).filter(|(a, _)| **a != 0.0).map(|(a, k)| (*a, k[i])).collect();
            V::sum(h, &terms)
        });
        [end, error, rates[rates.len() - 1]]
    }

    pub fn end<V: Vector>(&self, rate: impl Fn([V; 2]) -> [V; 2], p: [V; 2], h: f64) -> [V; 2] {
        self.step(rate, p, h)[0]
    }
}
