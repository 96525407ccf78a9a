// Finds the rays that turn inside the capture sphere of a nearly extremal black hole, which contains photon orbits. Ingoing light turns
// there if its radial potential has a root before the horizon: in y = r − r₊
//     R = P² − K y (y + d),  P = P₊ + E y (2r₊ + y),  d = r₊ − r₋,  P₊ = (r₊² + a²) E − aL,
// which is above 0 at both ends, so that its minimum decides: near the horizon R is nearly a parabola.

const TURN_STEPS: u32 = 3u;

fn orbit_turns(o: Orbit) -> bool {
    if !IS_EXTREME {
        return false;
    }
    let a2 = dot(law.spin, law.spin);
    let half = sqrt(max(law.mass * law.mass - a2 - law.charge_squared, 0.0));
    let horizon = law.mass + half;
    let width = 2.0 * half;
    let here = 1.0 / o.u - horizon;
    // E + (a²E − aL) u² is P u².
    let through = horizon * horizon * o.energy + o.lift;
    let steep = 2.0 * horizon * o.energy;
    let slope = 2.0 * through * steep - o.carter * width;
    let bend = 2.0 * (steep * steep + 2.0 * through * o.energy - o.carter);
    var y = -slope / bend;
    var least: Real = 1.0;
    for (var i = 0u; i <= TURN_STEPS; i++) {
        let p = through + o.energy * y * (2.0 * horizon + y);
        let rise = 2.0 * o.energy * (horizon + y);
        least = p * p - o.carter * y * (y + width);
        y -= (p * rise - o.carter * (y + half)) / (rise * rise + 2.0 * p * o.energy - o.carter);
    }
    return (o.w > 0.0) & (bend > 0.0) & (y > 0.0) & (y < here) & (least < 0.0);
}
