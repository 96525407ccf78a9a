// Logarithmic spirals: rays in n = k/r (T §5.2.2.2). With ψ the angle between the ray and the circle around the center, which is
// constant, and dσ = ds/r,
//
//     r = r₀ e^(σ sin ψ),    θ = σ cos ψ,
//
// which holds for circles (ψ = 0) and for radial rays (ψ = ±90°) too, unlike the r(θ) of T. Steps are measured in σ; a tightly
// wound ray makes any number of turns in one step.

struct Spiral {
    r: Real,
    // sin ψ and cos ψ.
    climb: Real,
    swing: Real,
    // Unit vectors: from the center to the ray, and perpendicular to it in the direction of motion.
    n: Real3,
    t: Real3,
}

fn spiral_of(p: Phase) -> Spiral {
    let d = p[0] - media[place].center;
    let r = length(d);
    let n = d / r;
    let u = normalize(p[1]);
    let climb = dot(n, u);
    let across = u - climb * n;
    let swing = length(across);
    // A radial ray never turns towards its t, so that any t will do.
    return Spiral(r, climb, swing, n, across / max(swing, 1e-30));
}

struct Stride {
    // The size, in σ.
    size: Real,
    // True if there is no object to hit on the way.
    free: bool,
}

fn law_start(x: Real3, v: Real3) -> Phase {
    let u = normalize(v);
    let n = normalize(x - media[place].center);
    let climb = dot(n, u);
    let flips = media[place].continued == 1u && climb < 0.0;
    return Phase(x, medium_index(x) * select(u, u - (2.0 * climb) * n, flips));
}

fn retaken_step(p: Phase, sigma: Real) -> Phase {
    let s = spiral_of(p);
    let r = s.r * real_exp(s.climb * sigma);
    let turn = real_sin_cos(s.swing * sigma);
    let n = turn.y * s.n + turn.x * s.t;
    let t = turn.y * s.t - turn.x * s.n;
    return Phase(media[place].center + r * n, (media[place].k / r) * (s.climb * n + s.swing * t));
}

// Returns τ for σ: ∫ r²/k dσ, with (e^z − 1)/z by its series where the difference loses digits.
fn spiral_tau(p: Phase, sigma: Real) -> Real {
    let s = spiral_of(p);
    let z = 2.0 * s.climb * sigma;
    let small = 1.0 + z * (0.5 + z * (1.0 / 6.0 + z / 24.0));
    let growth = select((real_exp(z) - 1.0) / select(z, 1.0, z == 0.0), small, abs(z) < 1e-2);
    return s.r * s.r / media[place].k * sigma * growth;
}

fn own_size(ray: Ray, next: Ray) -> Real {
    return spiral_stride(ray.phase).size;
}

fn own_measure(p: Phase, tau: Real) -> Real {
    let d = p[0] - media[place].center;
    return tau * media[place].k / dot(d, d);
}

fn own_pace(p: Phase) -> Real {
    let d = p[0] - media[place].center;
    return dot(d, d) / media[place].k;
}

fn own_tau(p: Phase, end: Phase, sigma: Real) -> Real {
    return spiral_tau(p, sigma);
}

fn own_fraction(p: Phase, end: Phase, t: Real) -> Real {
    return t;
}

fn accepted_step(ray: Ray) -> Ray {
    let way = spiral_stride(ray.phase);
    let passed = spiral_tau(ray.phase, way.size);
    var next = after_step(ray, retaken_step(ray.phase, way.size), passed);
    // A stretch that is clear of all objects is not tested as an arc.
    next.taken = select(next.taken, 0.0, way.free);
    return next;
}
