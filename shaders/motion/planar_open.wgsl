// Orbits with nothing to hit: as many steps in one segment as lie well within the bounding sphere and outside of what captures,
// in the plane all the while. The step that would leave is a segment of its own, cut so that it ends just outside.

struct Control {
    // Radians about the centre.
    eta: Real,
}

@group(0) @binding(60) var<uniform> control: Control;

fn first_step(p: Phase) -> Real {
    return 0.0;
}

fn retaken_step(p: Phase, s: Real) -> Phase {
    return orbit_point(orbit_step(orbit_of(p[0], p[1]), s));
}

const STEPS: u32 = 64u;
const CUTS: u32 = 4u;

// Inside this distance from the centre a ray is inside the bounding sphere, wherever that is: as u; beyond all u if there is none.
fn orbit_edge() -> Real {
    let inside = bound.radius - distance(bound.center, orbit_center());
    return select(1e30, 1.0 / inside, inside > 0.0);
}

// The size of the step by which u falls to the edge, from one by which it falls below: Newton's method, on a curve that is
// concave there, from the far side.
fn orbit_cut(o: Orbit, size: Real, edge: Real) -> Real {
    var s = size;
    for (var i = 0u; i < CUTS; i++) {
        work += 1u;
        let end = orbit_step(o, s);
        s = clamp(s - (end.u - edge) / min(end.w, -1e-30), 0.0, size);
    }
    return s;
}

fn orbit_size(o: Orbit) -> Real {
    return orbit_stride(o, control.eta, o.u + orbit_calm());
}

fn accepted_step(ray: Ray) -> Ray {
    let edge = orbit_edge();
    var next = ray;
    var here = orbit_of(ray.phase[0], ray.phase[1]);
    var steps = 0u;
    var passed: Real = 0.0;
    for (var i = 0u; i < STEPS; i++) {
        work += 1u;
        let s = orbit_size(here);
        let end = orbit_step(here, s);
        if end.u < edge || orbit_captured(end) {
            break;
        }
        passed += orbit_time(here, end, s);
        here = end;
        steps += 1u;
    }
    var s: Real = 0.0;
    if steps == 0u {
        // Where the bounding sphere lies off the centre a ray beyond the edge may still be inside: short steps, until it leaves.
        let beyond = here.u <= edge;
        s = select(orbit_size(here), orbit_stride(here, control.eta, here.u), beyond);
        let over = orbit_step(here, s);
        // Just outside, so that nobody doubts that it left.
        let cut = !beyond && over.u < edge;
        s = select(s, orbit_cut(here, s, 0.999 * edge), cut);
        let end = orbit_step(here, s);
        passed = orbit_time(here, end, s);
        here = end;
        steps = 1u;
    }
    next.phase = opaque_phase(orbit_point(here));
    next.tau += passed;
    next.taken = opaque(passed);
    next.memory.h = opaque(s);
    next.steps += steps;
    return next;
}
