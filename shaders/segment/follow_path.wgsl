// Follows a path with all its events, as far as the pass goes.

// Follows a path up to the next surface that scatters it, or to its end. Returns `true` if it continues from that surface.
//
// ray: the start of the segment under way, or of the last one; an ended ray stays there. end: receives the hit on which it ended.
fn follow_leg(spot: ActiveRay, ray: ptr<function, Ray>, end: ptr<function, Hit>, segments: ptr<function, u32>) -> bool {
    follow_segments(spot, ray, end, segments);
    // Rays that met a surface continue together, when no lane has a segment left.
    let meets = spot.alive && may_scatter((*ray).status);
    if meets {
        *ray = scatter_ray(*ray, end, spot.pixel);
    }
    return meets && (*ray).status == ALIVE;
}

// Follows a path to its end. Returns the hit on which it ended.
fn follow_path(spot: ActiveRay, ray: ptr<function, Ray>) -> Hit {
    var end = Hit(0.0, NOTHING);
    var segments = 0u;
    while follow_leg(spot, ray, &end, &segments) {
    }
    return end;
}
