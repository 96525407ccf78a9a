// Orbits with nothing to hit: as many steps in one segment as lie well within the bounding sphere and outside of what captures,
// in the plane all the while. The step that would leave is a segment of its own.

const STEPS: u32 = 64u;

// Inside this distance from the centre a ray is inside the bounding sphere, wherever that is: as u; beyond all u if there is none.
fn orbit_edge() -> Real {
    let inside = bound.radius - distance(bound.center, orbit_center());
    return select(1e30, 1.0 / inside, inside > 0.0);
}

// Where the bounding sphere lies off the centre a ray beyond the edge may still be inside: short steps, until it leaves.
fn orbit_size(o: Orbit, edge: Real, calm: Real) -> Real {
    return orbit_stride(o, control.eta, select(o.u + calm, o.u, o.u <= edge));
}

// The size of the step that leaves.
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
        // Both tests: a branch between them costs more than the second.
        if (end.u < edge) | orbit_captured(end) {
            break;
        }
        passed += orbit_time(here, end, s);
        here = end;
    }
    // The step that ends is taken again here: to keep it through the loop costs more.
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
