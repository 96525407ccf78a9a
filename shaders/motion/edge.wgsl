// The edge of the bounding sphere: the step across it is the last of a path, cut so that it ends just outside. If the sphere is not
// centered on the orbit's center, the edge is inside it, and paths cross it by ordinary steps.

const CUTS: u32 = 4u;

// Returns the size of the step by which u falls to the edge, from one by which it falls below: the Newton method, on a curve that is
// concave there, from the far side.
fn orbit_cut(o: Orbit, size: Real, edge: Real) -> Real {
    var s = size;
    for (var i = 0u; i < CUTS; i++) {
        let end = orbit_step(o, s);
        s = clamp(s - (end.u - edge) / min(end.w, -1e-30), 0.0, size);
    }
    return s;
}

// Shortens a step by which u falls below the edge, if it does.
fn left_size(o: Orbit, s: Real, edge: Real) -> Real {
    if !IS_ABOUT_CENTER {
        return s;
    }
    let over = orbit_step(o, s);
    return select(s, orbit_cut(o, s, 0.999 * edge), o.u > edge && over.u < edge);
}

// Returns roughly where a step that leaves crosses the edge, by the chord of u. Whether it left is known, and the exact position is found
// once, after the path has ended.
fn orbit_left(o: Orbit, over: Orbit, edge: Real) -> Orbit {
    if !IS_ABOUT_CENTER {
        return over;
    }
    let f = (o.u - edge) / max(o.u - over.u, 1e-30);
    var end = over;
    end.u = 0.999 * edge;
    end.w = min(over.w, -1e-30);
    end.angle = mix(o.angle, over.angle, f);
    return end;
}
