// Separated orbits with nothing to hit, in a bounding sphere around the black hole: a segment is a whole path, or STEPS of its steps. The
// step that would leave or be captured is corrected by the Newton method until it ends where the path does, so that no step has to be
// repeated to find the position. Every iteration does equal work: lanes that need a part of it and lanes that do not run together.

const STEPS: u32 = 256u;
const CUTS: u32 = 3u;

// Returns the u at which an inbound or outbound orbit ends: slightly beyond it.
fn orbit_stop(o: Orbit) -> Real {
    let captured = (1.0 + 16.0 * LAST_PART) / captured_within();
    // r² + a² sin²θ is the squared distance from the black hole.
    let across = dot(law.spin, law.spin) * dot(o.n.xy, o.n.xy);
    let left = (1.0 - 16.0 * LAST_PART) * inverseSqrt(bound.radius * bound.radius - across);
    // Accurate as far as steps keep n a unit vector.
    let inwards = select(captured, Real(1e30), orbit_turns(o));
    return select(left, inwards, o.w > 0.0) * length(o.n);
}

// The last step is never retaken to another end, so that τ can serve as its size.
fn own_size(ray: Ray, next: Ray) -> Real {
    return next.taken;
}

fn accepted_step(ray: Ray) -> Ray {
    var here = orbit_of(ray.phase[0], ray.phase[1]);
    var s = orbit_stride(here, control.eta, here.u);
    var longest = s;
    var steps = 0u;
    var cuts = 0u;
    var passed: Real = 0.0;
    for (var i = 0u; (i < STEPS) & (cuts <= CUTS); i++) {
        let end = orbit_step(here, s);
        let stop = orbit_stop(end);
        let beyond = (end.u - stop) * end.w > 0.0;
        let taken = orbit_time(here, end, s);
        // A ray that turns inwards inside the capture sphere is captured at once.
        let crosses = (cuts > 0u) | ((here.u - stop) * end.w < 0.0);
        cuts += select(0u, select(CUTS + 1u, 1u, crosses), beyond | (cuts > 0u));
        if (cuts == 0u) | (cuts > CUTS) {
            here = end;
            passed += taken;
            steps += 1u;
        }
        let cut = clamp(s - (end.u - stop) / end.w, 0.0, longest);
        s = select(cut, orbit_stride(here, control.eta, here.u), cuts == 0u);
        longest = select(longest, s, cuts == 0u);
    }
    var next = after_step(ray, orbit_point(here), passed);
    next.steps = ray.steps + steps;
    return next;
}
