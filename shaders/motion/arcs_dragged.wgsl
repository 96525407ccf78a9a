// Steps of separated orbits that a cubic is to follow: axes turn with ψ no further than n may, and on the way in Δ falls by half of itself at
// most, for towards the horizon both τ and ψ go on for ever.

fn orbit_arc_stride(o: Orbit, eta: Real, size: Real) -> Real {
    let closing = o.w * (law.mass - (dot(law.spin, law.spin) + law.charge_squared) * o.u);
    let delta = orbit_delta(o.u);
    let half = select(Real(1e30), 0.25 * delta / closing, min(delta, closing) > 0.0);
    let dragged = length(law.spin) * abs(o.gap - o.energy);
    return min(orbit_stride(o, eta, size), min(half, eta / max(dragged, 1e-30)));
}
