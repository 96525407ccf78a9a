//! Tests laws with closed formulas: both Schwarzschild forms, flows of both orders, straight lines.

use bentray::model::Value::{Float, Vec3 as V3};
use glam::{DVec3, Vec3, Vec4};

use super::{Errors, Random, U, row, vectors, wide};
use crate::support::{gpu, probe::Probe};

/// Evaluates the rate, start and scale of a law whose phase is a position and a velocity.
pub const LAW: &str = "let here = Phase(p0.xyz, p1.xyz);
    let rate = law_derivative(here);
    let start = law_start(p0.xyz, p1.xyz);
    let settled = law_projected(here);
    put(0u, vec4f(rate[0], law_scale(here)));
    put(1u, vec4f(rate[1], 0.0));
    put(2u, vec4f(start[0], 0.0));
    put(3u, vec4f(start[1], 0.0));
    put(4u, vec4f(settled[0], 0.0));
    put(5u, vec4f(settled[1], 0.0));";

/// Returns positions and velocities.
pub fn phases(seed: u64, places: [f64; 2], speeds: [f64; 2]) -> Vec<[Vec4; 2]> {
    let mut random = Random::new(seed);
    let xs = vectors(&mut random, 2000, places[0], places[1]);
    let mut vs = vectors(&mut random, xs.len(), speeds[0], speeds[1]);
    vs.truncate(xs.len());
    let mut all: Vec<[Vec4; 2]> = xs.iter().zip(vs).map(|(x, v)| [row(*x, 0.0), row(v, 0.0)]).collect();
    // Radial in both directions, and across.
    for d in super::awkward_directions() {
        let x = d * (places[0] * places[1]).sqrt() as f32;
        all.extend([
            [row(x, 0.0), row(d, 0.0)],
            [row(x, 0.0), row(-d, 0.0)],
            [row(x, 0.0), row(d.any_orthogonal_vector(), 0.0)],
        ]);
    }
    all
}

/// Checks a law that uses v unchanged.
pub fn keeps_phase(input: &[Vec4; 2], output: &[Vec4]) {
    assert_eq!(wide(output[0]), wide(input[1]), "dx = v");
    for (got, want) in output[2..6].iter().zip([input[0], input[1], input[0], input[1]]) {
        assert_eq!(got.truncate(), want.truncate(), "start and settled use the phase unchanged");
    }
}

const MASS: f64 = 1.25;
const CENTER: Vec3 = Vec3::new(0.5, -1.0, 0.25);

fn hole(part: &str, phase: &str) -> Probe {
    let law = vec![("center", V3(CENTER.as_dvec3())), ("mass", Float(MASS))];
    Probe::new(&["segment/ray", phase, part]).bind("law", [law])
}

#[test]
fn schwarzschild_path_form() {
    let inputs = phases(11, [0.05, 1e6], [1e-3, 1e3]);
    let out = hole("law/schwarzschild_path", "law/phase_space").run::<2, 6>(&gpu(), LAW, &inputs);
    let (mut rates, mut scales) = (Errors::of("schwarzschild_path rate"), Errors::of("schwarzschild_path scale"));
    for (input, output) in inputs.iter().zip(&out) {
        keeps_phase(input, output);
        let (x, v) = (wide(input[0]) - CENTER.as_dvec3(), wide(input[1]));
        let r = x.length();
        let l = x.cross(v).length();
        let want = -3.0 * MASS * l * l / r.powi(5) * x;
        // A component of x × v errs by 5 U |x| |v| (x − c rounds once, two products and their difference), so the vector by
        // 9 U; its square doubles that. The powers of r and the products err by 20 U.
        let cross = 9.0 * U * r * v.length();
        let bound = 3.0 * MASS / r.powi(4) * (2.0 * l * cross + cross * cross) + 20.0 * U * want.length();
        rates.check3(output[1], want, bound, input);
        let scale = r / v.length();
        scales.check(output[0].w, scale, 6.0 * U * scale, input);
    }
    rates.report();
    scales.report();
}

/// Rows of the time component; the other columns are as for laws of space.
const SPACETIME_LAW: &str = "let here = Phase(vec4f(p0.xyz, 0.0), vec4f(p1.xyz, p1.w));
    let rate = law_derivative(here);
    let start = law_start(p0.xyz, p1.xyz);
    let onward = law_derivative(start);
    put(0u, rate[0]);
    put(1u, rate[1]);
    put(2u, start[0]);
    put(3u, start[1]);
    put(4u, vec4f(onward[1].xyz, law_scale(here)));";

#[test]
fn schwarzschild_geodesic_form() {
    let mut random = Random::new(12);
    let mut inputs = phases(13, [2.0 * MASS, 1e5], [1e-2, 1e2]);
    for input in &mut inputs {
        // Outside the horizon, some barely.
        let x = input[0].truncate();
        let r = random.log(2.001 * MASS, 1e4).max(f64::from(x.length()).min(2e4)) as f32;
        *input = [
            row(CENTER + x.normalize() * r, 0.0),
            row(input[1].truncate(), random.within(0.5, 2.0) as f32 * input[1].length()),
        ];
    }
    let out = hole("law/schwarzschild_geodesic", "law/phase_spacetime").run::<2, 5>(&gpu(), SPACETIME_LAW, &inputs);
    let names = [
        "geodesic rate",
        "geodesic clock's rate",
        "geodesic start's clock",
        "geodesic and path form",
        "geodesic scale",
    ];
    let [mut rates, mut clocks, mut starts, mut forms, mut scales] = names.map(Errors::of);
    for (input, output) in inputs.iter().zip(&out) {
        let (x, v, clock) = (wide(input[0]) - CENTER.as_dvec3(), wide(input[1]), f64::from(input[1].w));
        let r = x.length();
        let n = x / r;
        let radial = n.dot(v);
        let v2 = v.length_squared();
        let across2 = (v - radial * n).length_squared();
        let f = 1.0 - 2.0 * MASS / r;
        assert_eq!(wide(output[0]), v);
        assert_eq!(output[0].w, input[1].w);
        assert_eq!((output[2].truncate(), output[3].truncate()), (input[0].truncate(), input[1].truncate()));
        // f errs by 4 U of 1, so by 4 U/f of itself; every other term errs by 20 U of |v|².
        let slack = U * (20.0 + 8.0 / f);
        let near = f < 0.05;
        if (f - 0.05).abs() > 1e-6 {
            // The geodesic equation with (|v|² − ṙ²) as |v⊥|².
            let far = -MASS * (r - 2.0 * MASS) / r.powi(3) * clock * clock
                + MASS / (r * (r - 2.0 * MASS)) * radial * radial
                - 2.0 * MASS * across2 / (r * r);
            let want = if near { -3.0 * MASS * across2 / (r * r) } else { far };
            let terms = MASS / (r * r) * (f * clock * clock + v2 / f.max(0.05) + 3.0 * v2);
            rates.check3(output[1], want * n, slack * terms, input);
            let want = if near { 0.0 } else { -2.0 * MASS / (r * (r - 2.0 * MASS)) * radial * clock };
            let terms = 2.0 * MASS / (r * r * f.max(0.05)) * v2.sqrt() * clock;
            clocks.check(output[1].w, want, slack * terms, input);
        }
        let start = ((across2 + radial * radial / f) / f).sqrt();
        starts.check(output[3].w, start, slack * ((v2 + v2 / f) / f).sqrt(), input);
        // With the null condition at the start both forms have the same dv.
        let l = x.cross(v);
        let path = -3.0 * MASS * l.length_squared() / r.powi(5) * x;
        let terms = MASS / (r * r) * (2.0 * v2 / f + 3.0 * v2);
        forms.check3(output[4], path, 2.0 * slack * terms, input);
        let scale = (r - 2.0 * MASS).max(0.1 * MASS) / v2.sqrt();
        scales.check(output[4].w, scale, 4.0 * U * r / v2.sqrt() + 8.0 * U * scale, input);
    }
    for errors in [rates, clocks, starts, forms, scales] {
        errors.report();
    }
}

const SPIN: DVec3 = DVec3::new(0.6, -0.5, 0.75);
const CHARGE: f64 = 0.5;

/// The Hamiltonian h for g = η + f l l, with f and l in their textbook form, around an axis e.
struct Hamilton {
    e: DVec3,
    a: f64,
}

impl Hamilton {
    fn field(&self, x: DVec3) -> (f64, DVec3) {
        let z = x.dot(self.e);
        let b = x.length_squared() - self.a * self.a;
        let r = (0.5 * (b + (b * b + 4.0 * (self.a * z).powi(2)).sqrt())).sqrt();
        let f = r * r * (2.0 * MASS * r - CHARGE * CHARGE) / (r.powi(4) + (self.a * z).powi(2));
        let across = (r * (x - z * self.e) + self.a * x.cross(self.e)) / (r * r + self.a * self.a);
        (f, across + z / r * self.e)
    }

    fn energy(&self, x: DVec3, p: DVec3) -> f64 {
        let (f, l) = self.field(x);
        let w = l.dot(p);
        (((1.0 + f) * p.length_squared() - f * w * w).sqrt() + f * w) / (1.0 + f)
    }

    /// Returns the gradient of h by differences, as everything else here; the gradient by p is dx/dτ.
    fn gradient(of: impl Fn(DVec3) -> f64, at: DVec3, step: f64) -> DVec3 {
        DVec3::from_array([DVec3::X, DVec3::Y, DVec3::Z].map(|d| {
            let slope = |h: f64| (of(at + h * d) - of(at - h * d)) / (2.0 * h);
            (4.0 * slope(0.5 * step) - slope(step)) / 3.0
        }))
    }

    fn velocity(&self, x: DVec3, p: DVec3) -> DVec3 {
        Self::gradient(|p| self.energy(x, p), p, 1e-3 * p.length())
    }

    /// Returns dv/dτ along the Hamiltonian flow.
    fn acceleration(&self, x: DVec3, p: DVec3) -> DVec3 {
        let (v, force) = (self.velocity(x, p), -Self::gradient(|x| self.energy(x, p), x, 1e-3 * x.length()));
        let at = |t: f64| self.velocity(x + t * v, p + t * force);
        let slope = |t: f64| (at(t) - at(-t)) / (2.0 * t);
        let t = 1e-3 * x.length() / v.length().max(1.0);
        (4.0 * slope(0.5 * t) - slope(t)) / 3.0
    }
}

/// The congruence form of the geodesic equation agrees with the Hamiltonian one, which has no shear and twist. Outside the horizon, where
/// |x|² < 2r² as a < M, functions of r have a relative error of about 4 U, and those of these of about 8 U, over 1 − f if a root loses
/// that. Second differences are accurate to 1e-9.
#[test]
fn kerr_newman() {
    let (a, e) = (SPIN.length(), SPIN.normalize());
    let hamilton = Hamilton { e, a };
    let inputs: Vec<_> = phases(14, [2.2 * MASS, 1e4], [0.5, 2.0]);
    let probe = Probe::new(&[
        "segment/ray",
        "law/phase_space",
        "law/by_velocity",
        "law/projected_as_is",
        "law/spheroid",
        "law/light_speed",
        "law/kerr_newman",
    ]);
    let law = vec![
        ("center", V3(CENTER.as_dvec3())),
        ("mass", Float(MASS)),
        ("spin", V3(SPIN)),
        ("charge_squared", Float(CHARGE * CHARGE)),
        ("axis", V3(SPIN.normalize())),
    ];
    let probe = probe.bind("law", [law]);
    let started = probe.run::<2, 6>(&gpu(), LAW, &inputs);
    let light: Vec<_> = inputs.iter().zip(&started).map(|(input, start)| [input[0], start[3]]).collect();
    let out = probe.run::<2, 6>(&gpu(), LAW, &light);
    let names = ["kerr_newman pull", "kerr_newman null condition", "kerr_newman restart", "kerr_newman scale"];
    let [mut pulls, mut nulls, mut restarts, mut scales] = names.map(Errors::of);
    for (input, output) in light.iter().zip(&out) {
        let (x, v) = (wide(input[0]) - CENTER.as_dvec3(), wide(input[1]));
        let (f, l) = hamilton.field(x);
        if !v.is_finite() || f >= 0.95 {
            continue;
        }
        let w = 1.0 - l.dot(v);
        let fast = 1.0 + v.length();
        // |b| + √(b² + (1−f)c) loses the digits that 1 − f loses.
        nulls.check((v.length_squared() + f * w * w) as f32, 1.0, 6.0 * U * fast * fast / (1.0 - f), input);
        restarts.check3(output[3], v, 6.0 * U * fast * fast / (1.0 - f), input);
        let r = x.length();
        let terms = f / r * fast * fast * (2.0 + f) + f * fast * fast * fast / r;
        pulls.check3(output[1], hamilton.acceleration(x, v - f * w * l), (8.0 * U + 1e-9) * terms / (1.0 - f), input);
        assert!(wide(output[0]) == v);
        let scale = output[0].w;
        scales.check(scale, bentray::model::point_source::spheroid::of(x, SPIN).0, 8.0 * U * f64::from(scale), input);
    }
    for errors in [pulls, nulls, restarts, scales] {
        errors.report();
    }
}

type Field = fn(DVec3) -> (DVec3, f64);

/// Returns F and the size of its terms.
pub fn lorenz(x: DVec3) -> (DVec3, f64) {
    let (sigma, rho, beta) = (10.0, 28.0, f64::from(8.0_f32 / 3.0));
    let f = DVec3::new(sigma * (x.y - x.x), rho * x.x - x.y - x.x * x.z, x.x * x.y - beta * x.z);
    (f, 28.0 * (x.x.abs() + x.y.abs() + x.z.abs()) + (x.x * x.z).abs() + (x.x * x.y).abs())
}

fn rossler(x: DVec3) -> (DVec3, f64) {
    let (alpha, beta, gamma) = (0.375, 2.0, 4.0);
    let f = DVec3::new(-(x.y + x.z), x.x + alpha * x.y, beta + x.z * (x.x - gamma));
    (f, beta + 4.0 * (x.x.abs() + x.y.abs() + x.z.abs()) + (x.x * x.z).abs())
}

pub fn flow(part: &str, order: &str) -> Probe {
    let values = if part == "law/field_lorenz" {
        vec![("sigma", Float(10.0)), ("rho", Float(28.0)), ("beta", Float(f64::from(8.0_f32 / 3.0)))]
    } else {
        vec![("alpha", Float(0.375)), ("beta", Float(2.0)), ("gamma", Float(4.0))]
    };
    Probe::new(&["segment/ray", "law/phase_space", part, order]).bind("flow", [values])
}

#[test]
fn flows_of_both_orders() {
    let gpu = gpu();
    let inputs = phases(14, [1e-6, 1e5], [1e-3, 1e3]);
    // The rate at which volumes shrink, and the rate of z near z = 0.
    let fields: [(&str, Field, f64); 2] =
        [("law/field_lorenz", lorenz, 10.0 + 1.0 + 8.0 / 3.0), ("law/field_rossler", rossler, 1.0 + 0.375 + 4.0)];
    for (part, field, fastest) in fields {
        let mut errors = Errors::of("flows");
        let first = flow(part, "law/flow").run::<2, 6>(&gpu, LAW, &inputs);
        let second = flow(part, "law/flow_acceleration").run::<2, 6>(&gpu, LAW, &inputs);
        for ((input, a), b) in inputs.iter().zip(&first).zip(&second) {
            let (want, terms) = field(wide(input[0]));
            // Each term has three roundings.
            let bound = 4.0 * U * terms;
            errors.check3(a[0], want, bound, input);
            assert_eq!(wide(a[1]), DVec3::ZERO, "a flow's v has no rate");
            assert_eq!((a[2].truncate(), a[4].truncate()), (input[0].truncate(), input[0].truncate()));
            errors.check3(a[3], want, bound, input);
            errors.check3(a[5], want, bound, input);
            errors.check(a[0].w, 1.0 / fastest, 4.0 * U / fastest, input);
            keeps_phase(input, b);
            errors.check3(b[1], want, bound, input);
            errors.check(b[0].w, fastest.recip().sqrt(), 4.0 * U, input);
        }
        errors.report();
    }
}

#[test]
fn straight_lines_have_no_rate() {
    let inputs = phases(15, [1e-3, 1e5], [1e-3, 1e3]);
    let bound = vec![("center", V3(DVec3::ZERO)), ("radius", Float(50.0))];
    let probe = Probe::new(&["segment/ray", "law/bound", "law/leaving", "law/phase_space", "law/straight"])
        .bind("bound", [bound]);
    let mut scales = Errors::of("straight scale");
    for (input, output) in inputs.iter().zip(&probe.run::<2, 6>(&gpu(), LAW, &inputs)) {
        keeps_phase(input, output);
        assert_eq!(wide(output[1]), DVec3::ZERO);
        let scale = 50.0 / wide(input[1]).length();
        scales.check(output[0].w, scale, 6.0 * U * scale, input);
    }
    scales.report();
}
