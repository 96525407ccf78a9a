// A path with all that happens on it, as far as the pass goes.

// ray: the start of the segment under way, or of the last one; an ended ray stays there. Returns what it ended on.
fn follow_path(spot: ActiveRay, ray: ptr<function, Ray>) -> Hit {
    var end = Hit(0.0, NOTHING);
    var segments = 0u;
    loop {
        follow_segments(spot, ray, &end, &segments);
        // Those that met a surface go on from it together, when none has a segment left to its own.
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
