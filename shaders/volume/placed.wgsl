// The variables of formulas at a position.

struct MatterPlace {
    q: Real3,
    time: Real,
    r: Real,
    // The distance from the axis.
    rho: Real,
    // The sine and the cosine of the polar angle.
    sine: Real,
    cosine: Real,
    // The values of grids.
    grids: array<Real, 8>,
}

// Relative to an origin, along the axes of the scene.
fn placed_by_origin(spot: Spot, origin: Real3) -> MatterPlace {
    let q = spot.x - origin;
    let rho = length(q.xy);
    let r = length(q);
    let inverse = 1.0 / max(r, 1e-30);
    return MatterPlace(q, spot.time, r, rho, rho * inverse, q.z * inverse, array<Real, 8>());
}

// In the coordinates of the law, along its axis.
fn placed_by_law(spot: Spot) -> MatterPlace {
    let q = formula_axes(law_arm(spot.x));
    return MatterPlace(q, spot.time, spot.r, length(q.xy), spot.sine, spot.cosine, array<Real, 8>());
}

fn formula_axes(arm: Real3) -> Real3 {
    return Real3(dot(transfer.first, arm), dot(transfer.second, arm), dot(transfer.third, arm));
}

// Density below this is none, as rounding in 32 bits makes it.
const LEAST_DENSITY: Real = 1e-37;

// Adds matter to a channel.
fn add_matter(matter: ptr<function, Matter>, k: u32, emission: Real, absorption: Real) {
    let valid = emission >= 0.0 && absorption >= 0.0 && emission < 1e30 && absorption < 1e30;
    transfer_invalid = transfer_invalid || !valid;
    (*matter).emission[k] += select(0.0, emission, valid);
    (*matter).absorption[k] += select(0.0, absorption, valid);
}

// Returns the Planck function at nu, in units of ν₀: most ν³/(e^x − 1), with x = kelvin ν/temperature.
fn planck(nu: Real, most: Real, kelvin: Real, temperature: Real) -> Real {
    let x = kelvin * nu / temperature;
    let grown = select(real_exp(min(x, 80.0)) - 1.0, x * (1.0 + 0.5 * x * (1.0 + x / 3.0 * (1.0 + 0.25 * x))), x < 0.02);
    return select(most * nu * nu * nu / grown, 0.0, x > 80.0);
}
