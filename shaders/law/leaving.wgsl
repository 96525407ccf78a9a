// Finds where paths leave the bounding sphere, and where they enter it.

fn left_bound(x: Real3, v: Real3) -> bool {
    return outside_bound(x) && dot(bound_offset(x), v) > 0.0;
}

// Returns `true` if x is outside the sphere, in whatever direction it moves.
fn outside_bound(x: Real3) -> bool {
    let d = bound_offset(x);
    return dot(d, d) > bound.radius * bound.radius;
}

// Returns the distance along v at which the line through x enters the sphere: 0 from inside, negative if it never does.
fn bound_entry(x: Real3, v: Real3) -> Real {
    let d = bound_offset(x);
    let outside = dot(d, d) - bound.radius * bound.radius;
    if outside <= 0.0 {
        return 0.0;
    }
    let b = dot(d, v);
    let vv = dot(v, v);
    // The distance of the nearest point, computed directly instead of as b² − |v|²|d|²: that difference loses all digits far away.
    let miss = d - (b / vv) * v;
    let inside = bound.radius * bound.radius - dot(miss, miss);
    if b >= 0.0 || inside < 0.0 {
        return -1.0;
    }
    return -b / vv - sqrt(inside / vv);
}
