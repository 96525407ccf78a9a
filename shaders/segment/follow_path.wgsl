// Follows a path with all its events, as far as the pass goes.

// ray: the start of the segment under way, or of the last one; an ended ray stays there. Returns the hit on which it ended.
fn follow_path(spot: ActiveRay, ray: ptr<function, Ray>) -> Hit {
    var end = Hit(0.0, NOTHING);
    var segments = 0u;
    loop {
        follow_segments(spot, ray, &end, &segments);
        // Rays that met a surface continue together, when no lane has a segment left.
        if !may_scatter((*ray).status) || !spot.alive {
            break;
        }
        *ray = scatter_ray(*ray, &end, spot.pixel);
        if (*ray).status != ALIVE {
            break;
        }
    }
    return end;
}
