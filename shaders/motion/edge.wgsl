// The edge is the bounding sphere itself: the step across it is a path's last, cut so that it ends just outside. Where the
// sphere lies off the centre the edge is within it, and paths go on across it by steps like any other.

const CUTS: u32 = 4u;

// The size of the step by which u falls to the edge, from one by which it falls below: Newton's method, on a curve that is
// concave there, from the far side.
fn orbit_cut(o: Orbit, size: Real, edge: Real) -> Real {
    var s = size;
    for (var i = 0u; i < CUTS; i++) {
        let end = orbit_step(o, s);
        s = clamp(s - (end.u - edge) / min(end.w, -1e-30), 0.0, size);
    }
    return s;
}

// From a step by which u falls below the edge, if it does.
fn left_size(o: Orbit, s: Real, edge: Real) -> Real {
    if !IS_ABOUT_CENTER {
        return s;
    }
    let over = orbit_step(o, s);
    return select(s, orbit_cut(o, s, 0.999 * edge), o.u > edge && over.u < edge);
}

// Roughly where a step that leaves crosses the edge, by the chord of u: whether it left is known, and exactly where is found
// once, when the path has ended.
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
