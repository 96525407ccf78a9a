// A wormhole that joins two positions by a throat: ds² = −dt² + dl² + r(l)² dΩ², where l is the proper distance from the throat, above 0 on
// this side and below 0 on the other. Each side is drawn around its own mouth, x = R n̂ with R = ρ₀ + |l|, so that radial lengths are
// true and the throat is the sphere R = ρ₀. With n̂′ = v⊥/R and r² n̂′ constant in its plane,
//     x″ = (r r′ − R) |v⊥|²/R² n̂ + 2 v_R (1/R − r′/r) v⊥,
// which also holds slightly beyond the throat, where steps end that are cut at it.

struct Law {
    center: Real3,
    // The mouth of the other side.
    other: Real3,
    // ρ₀.
    radius: Real,
    // a: r is ρ₀ where |l| is less than this.
    half_length: Real,
    // M: the length over which r starts to grow beyond that.
    mouth: Real,
}

var<uniform> law: Law;

// Returns the position of x relative to the nearer mouth.
fn mouth_offset(x: Real3) -> Real3 {
    let here = x - law.center;
    let there = x - law.other;
    return select(here, there, dot(there, there) < dot(here, here));
}

fn law_acceleration_by_velocity(at: Real3, v: Real3) -> Real3 {
    let x = mouth_offset(at);
    let away = length(x);
    let n = x / away;
    let throat = throat_radius(away - law.radius);
    let rising = dot(n, v);
    let across = v - rising * n;
    let outwards = (throat.x * throat.y - away) / (away * away) * dot(across, across);
    return outwards * n + (2.0 * rising * (1.0 / away - throat.y / throat.x)) * across;
}

// Returns the ray's start, with the speed of light along v.
fn law_start(at: Real3, v: Real3) -> Phase {
    let x = mouth_offset(at);
    let away = length(x);
    let rising = dot(x, v) / away;
    let across = v - (rising / away) * x;
    let wider = throat_radius(away - law.radius).x / away;
    return Phase(at, v * inverseSqrt(rising * rising + wider * wider * dot(across, across)));
}

// Returns the tau over which the law changes: R, or less near the point where the throat opens.
fn law_scale(p: Phase) -> Real {
    let away = length(mouth_offset(p[0]));
    return min(away, abs(abs(away - law.radius) - law.half_length) + law.mouth);
}
