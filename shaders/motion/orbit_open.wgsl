// Orbits with nothing to hit: a segment takes as many steps as are well within the bounding sphere and outside the capture sphere, always
// in the plane of the orbit. The step that would leave is a separate segment.

const STEPS: u32 = 64u;

// Returns the edge as u: inside this distance from the center a ray is inside the bounding sphere, wherever that is; above every u if there
// is none.
fn orbit_edge() -> Real {
    let inside = bound.radius - distance(bound.center, orbit_center());
    return select(1e30, 1.0 / inside, inside > 0.0);
}

// If the bounding sphere is not centered, a ray beyond the edge may still be inside: it takes short steps until it leaves.
fn orbit_size(o: Orbit, edge: Real, calm: Real) -> Real {
    return orbit_stride(o, control.eta, select(o.u + calm, o.u, o.u <= edge));
}

// Returns the size of the step that leaves.
fn own_size(ray: Ray, next: Ray) -> Real {
    let edge = orbit_edge();
    let o = orbit_of(ray.phase[0], ray.phase[1]);
    let s = orbit_size(o, edge, orbit_calm());
    return left_size(o, s, edge);
}

fn accepted_step(ray: Ray) -> Ray {
    let edge = orbit_edge();
    let calm = orbit_calm();
    let start = orbit_of(ray.phase[0], ray.phase[1]);
    var here = start;
    var steps = 0u;
    var passed: Real = 0.0;
    for (; steps < STEPS; steps++) {
        let s = orbit_size(here, edge, calm);
        let end = orbit_step(here, s);
        // Both tests at once: a branch between them costs more than the second.
        if (end.u < edge) | orbit_captured(end) {
            break;
        }
        passed += orbit_time(here, end, s);
        here = end;
    }
    // The step that ends is repeated here: storing it through the loop costs more.
    if steps == 0u {
        let s = orbit_size(start, edge, calm);
        here = orbit_step(start, s);
        if (start.u > edge) & (here.u < edge) {
            here = orbit_left(start, here, edge);
        }
        passed = orbit_time(start, here, s);
        steps = 1u;
    }
    var next = after_step(ray, orbit_point(here), passed);
    next.steps = ray.steps + steps;
    return next;
}
