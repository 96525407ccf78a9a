//! Media that are formulas. x − c rounds once (u of |x − c|), and (x − c)/R twice, so that its square is off by 7u of itself.

use glam::DVec3;

use super::{BOUND, Case, WAVELENGTH, Want, exp_error, root_error};

const CENTER: DVec3 = DVec3::new(0.5, -0.25, 1.0);
/// An axis as scenes give it, and as a unit vector.
const UP: DVec3 = DVec3::new(0.6, 0.0, 0.8);

const NOWHERE: fn(DVec3, f64) -> bool = |_, _| false;

/// Returns the pull of a spherical medium, from the slope of n along r, and its error.
fn radial(d: DVec3, n: f64, slope: f64, error: f64) -> (DVec3, f64) {
    let pull = n * slope * d.normalize_or_zero();
    (pull, error * pull.length())
}

#[test]
fn constant() {
    let case = Case {
        name: "constant",
        parts: &["medium/constant"],
        index: "{ kind = \"constant\", n = 1.5 }",
        center: CENTER,
        reach: [1e-3, 1e3],
        regular: true,
        want: |_, _| Want { n: (1.5, 0.0), pull: (DVec3::ZERO, 0.0), length: (BOUND, 0.0) },
        undecided: NOWHERE,
    };
    case.check();
}

#[test]
fn sellmeier() {
    let case = Case {
        name: "sellmeier",
        parts: &["medium/sellmeier", "medium/wavelength"],
        index: "{ kind = \"sellmeier\", b = [1.25, 0.25], c = [0.0078125, 100] }",
        center: CENTER,
        reach: [1e-3, 1e3],
        regular: true,
        want: |_, u| {
            let square = WAVELENGTH * WAVELENGTH;
            let n = (1.0 + 1.25 * square / (square - 0.007_812_5) + 0.25 * square / (square - 100.0)).sqrt();
            Want { n: (n, 8.0 * u * n), pull: (DVec3::ZERO, 0.0), length: (BOUND, 0.0) }
        },
        undecided: NOWHERE,
    };
    case.check();
}

#[test]
fn luneburg() {
    let case = Case {
        name: "luneburg",
        parts: &["medium/luneburg"],
        index: "{ kind = \"luneburg\", center = [0.5, -0.25, 1], radius = 3, c = 2.5 }",
        center: CENTER,
        reach: [1e-6, 20.0],
        regular: true,
        want: |x, u| {
            let d = x - CENTER;
            let q2 = d.length_squared() / 9.0;
            let square = 2.5 - q2;
            let n = square.max(0.0).sqrt();
            let n_error = root_error(square, u * (8.0 * q2 + square.abs())) + 2.0 * u * n;
            Want { n: (n, n_error), pull: (-d / 9.0, 4.0 * u * d.length() / 9.0), length: (3.0, 0.0) }
        },
        undecided: NOWHERE,
    };
    case.check();
    case.pull_is_the_slope(1e-6);
}

fn gaussian_want(x: DVec3, u: f64, b: f64) -> Want {
    let d = x - CENTER;
    let q2 = d.length_squared() / 4.0;
    let z = b * q2;
    let n = 1.5 * (-z).exp();
    let relative = exp_error(z, 8.0 * u * z.abs(), u) + 2.0 * u;
    // The larger of R⁻² and the bound on |n″/n|.
    let steep = (2.0 * b.abs() * (1.0 + 2.0 * b.abs() * q2)).max(1.0);
    let slope = -2.0 * b * d.length() / 4.0 * n;
    let length = 2.0 / steep.sqrt();
    Want {
        // An exponential below the range of normal numbers is 0.
        n: (n, n * relative + 1.5 * f64::from(f32::MIN_POSITIVE)),
        pull: radial(d, n, slope, 2.0 * relative + 10.0 * u),
        length: (length, 10.0 * u * length),
    }
}

#[test]
fn gaussian() {
    let case = Case {
        name: "gaussian",
        parts: &["medium/gaussian"],
        index: "{ kind = \"gaussian\", center = [0.5, -0.25, 1], radius = 2, a = 1.5, b = 0.375 }",
        center: CENTER,
        reach: [1e-6, 1e3],
        regular: true,
        want: |x, u| gaussian_want(x, u, 0.375),
        undecided: NOWHERE,
    };
    case.check();
    Case { reach: [1e-6, 8.0], ..case }.pull_is_the_slope(1e-6);
    // A medium whose index grows outward.
    let case = Case {
        name: "growing gaussian",
        parts: &["medium/gaussian"],
        index: "{ kind = \"gaussian\", center = [0.5, -0.25, 1], radius = 2, a = 1.5, b = -0.5 }",
        center: CENTER,
        reach: [1e-6, 8.0],
        regular: true,
        want: |x, u| gaussian_want(x, u, -0.5),
        undecided: NOWHERE,
    };
    case.check();
    case.pull_is_the_slope(1e-6);
}

#[test]
fn inverse_r() {
    let case = Case {
        name: "inverse r",
        parts: &["medium/inverse_r"],
        index: "{ kind = \"inverse-r\", center = [0.5, -0.25, 1], k = 4 }",
        center: CENTER,
        // Closer to the center x − c has no correct digits in f32.
        reach: [1e-5, 1e8],
        regular: false,
        want: |x, u| {
            let d = x - CENTER;
            let (r, n) = (d.length(), 4.0 / d.length());
            Want { n: (n, 6.0 * u * n), pull: radial(d, n, -n / r, 16.0 * u), length: (r, 4.0 * u * r) }
        },
        undecided: NOWHERE,
    };
    case.check();
    case.pull_is_the_slope(1e-6);
}

#[test]
fn fisheye() {
    let case = Case {
        name: "fisheye",
        parts: &["medium/fisheye"],
        index: "{ kind = \"maxwell-fisheye\", center = [0.5, -0.25, 1], n0 = 2, a = 1.5 }",
        center: CENTER,
        reach: [1e-6, 1e4],
        regular: true,
        want: |x, u| {
            let d = x - CENTER;
            let r = d.length();
            let n = 2.0 / (1.0 + r * r / 2.25);
            // n = n₀ a²/(a² + r²): n′ = −2 n r/(a² + r²).
            let slope = -2.0 * n * r / (2.25 + r * r);
            let length = (2.25 + r * r).sqrt();
            Want { n: (n, 10.0 * u * n), pull: radial(d, n, slope, 40.0 * u), length: (length, 6.0 * u * length) }
        },
        undecided: NOWHERE,
    };
    case.check();
    case.pull_is_the_slope(1e-6);
}

#[test]
fn eaton() {
    let case = Case {
        name: "eaton",
        parts: &["medium/eaton"],
        index: "{ kind = \"eaton\", center = [0.5, -0.25, 1], radius = 3 }",
        center: CENTER,
        reach: [1e-5, 20.0],
        regular: false,
        want: |x, u| {
            let d = x - CENTER;
            let r = d.length();
            let square = 6.0 / r - 1.0;
            let n = square.max(0.0).sqrt();
            let n_error = root_error(square, 7.0 * u * 6.0 / r) + 2.0 * u * n;
            // n n′ = −R/r².
            let pull = -3.0 / (r * r) * (d / r);
            Want { n: (n, n_error), pull: (pull, 14.0 * u * pull.length()), length: (r, 4.0 * u * r) }
        },
        undecided: NOWHERE,
    };
    case.check();
    case.pull_is_the_slope(1e-6);
}

#[test]
fn rod() {
    let case = Case {
        name: "rod",
        parts: &["medium/rod"],
        index: "{ kind = \"rod\", center = [0.5, -0.25, 1], axis = [0.6, 0, 0.8], n0 = 1.625, g = 0.25 }",
        center: CENTER,
        reach: [1e-6, 30.0],
        regular: true,
        want: |x, u| {
            let d = x - CENTER;
            let off = d - d.dot(UP) * UP;
            let rho2 = off.length_squared();
            let square = 1.0 - rho2 / 16.0;
            let n = 1.625 * square.max(0.0).sqrt();
            // The axis errs by u and the part along it by 6u of |d|, and so does the remainder.
            let moved = 12.0 * u * d.length();
            let error = (2.0 * rho2.sqrt() * moved + moved * moved + 8.0 * u * rho2) / 16.0 + u;
            let stiffness = (1.625_f64 * 0.25).powi(2);
            Want {
                n: (n, 1.625 * root_error(square, error) + 2.0 * u * n),
                pull: (-stiffness * off, stiffness * (moved + 6.0 * u * rho2.sqrt())),
                length: (4.0, 2.0 * u * 4.0),
            }
        },
        undecided: NOWHERE,
    };
    case.check();
    case.pull_is_the_slope(1e-6);
}

#[test]
fn linear() {
    const GRADIENT: DVec3 = DVec3::new(0.0625, 0.25, -0.125);
    let case = Case {
        name: "linear",
        parts: &["medium/linear"],
        index: "{ kind = \"linear\", origin = [0.5, -0.25, 1], n0 = 1.25, gradient = [0.0625, 0.25, -0.125] }",
        center: CENTER,
        reach: [1e-6, 30.0],
        regular: true,
        want: |x, u| {
            let d = x - CENTER;
            let square = 1.5625 + GRADIENT.dot(d);
            let n = square.max(0.0).sqrt();
            let error = u * (2.0 * 1.5625 + 6.0 * GRADIENT.abs().dot(d.abs()));
            let length = 1.5625 / GRADIENT.length();
            Want {
                n: (n, root_error(square, error) + 2.0 * u * n),
                pull: (0.5 * GRADIENT, 0.0),
                length: (length, 8.0 * u * length),
            }
        },
        undecided: NOWHERE,
    };
    case.check();
    case.pull_is_the_slope(1e-6);
}

fn exponential_want(x: DVec3, u: f64, delta: f64) -> Want {
    let d = x - CENTER;
    let z = -UP.dot(d) / 2.0;
    let more = delta * z.exp();
    // The height errs by 8u of |d|, which includes the rounding of the direction.
    let relative = exp_error(z, (8.0 * d.length() / 2.0 + z.abs()) * u, u) + u;
    let n = (1.0 + more).max(0.0);
    let pull = -(1.0 + more) * more / 2.0 * UP;
    let pull_error = pull.length() * (relative + 6.0 * u) + more * more / 2.0 * relative;
    Want { n: (n, more.abs() * relative + 2.0 * u * n), pull: (pull, pull_error), length: (2.0, 0.0) }
}

#[test]
fn exponential() {
    let case = Case {
        name: "exponential",
        parts: &["medium/exponential"],
        index: "{ kind = \"exponential\", origin = [0.5, -0.25, 1], up = [0.6, 0, 0.8], delta = 0.125, height = 2 }",
        center: CENTER,
        reach: [1e-6, 50.0],
        regular: true,
        want: |x, u| exponential_want(x, u, 0.125),
        undecided: NOWHERE,
    };
    case.check();
    case.pull_is_the_slope(1e-6);
    let case = Case {
        name: "thin exponential",
        index: "{ kind = \"exponential\", origin = [0.5, -0.25, 1], up = [0.6, 0, 0.8], delta = -0.5, height = 2 }",
        want: |x, u| exponential_want(x, u, -0.5),
        reach: [1e-6, 10.0],
        ..case
    };
    case.check();
    case.pull_is_the_slope(1e-6);
}

#[test]
fn sech() {
    let case = Case {
        name: "sech",
        parts: &["medium/sech"],
        index: "{ kind = \"sech\", origin = [0.5, -0.25, 1], up = [0.6, 0, 0.8], n0 = 1.5, g = 0.5 }",
        center: CENTER,
        reach: [1e-6, 1e3],
        regular: true,
        want: |x, u| {
            let d = x - CENTER;
            let z = 0.5 * UP.dot(d);
            // cosh only overflows if n is far below any bound.
            let (n, tanh) = (1.5 / z.cosh(), z.tanh());
            let relative = exp_error(z, (0.5 * 8.0 * d.length() + z.abs()) * u, u);
            let flat = 0.5 * n * n;
            Want {
                // If e^(−|z|) is below the range of normal numbers it is 0; n is three times that.
                n: (n, n * (2.0 * relative + 5.0 * u) + 3.0 * f64::from(f32::MIN_POSITIVE)),
                pull: (-flat * tanh * UP, flat * (5.0 * relative + 20.0 * u)),
                length: (2.0, 2.0 * u),
            }
        },
        undecided: NOWHERE,
    };
    case.check();
    Case { reach: [1e-6, 20.0], ..case }.pull_is_the_slope(1e-6);
}
