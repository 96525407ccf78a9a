// K segments with all their stages in one pass (`fused`): integrate, intersect, terminate, scatter, the state through the textures
// only between passes. A pass ends at a segment's boundary, before the device's limit of loop iterations, or where a walk is
// suspended.

@compute @workgroup_size(GROUP)
fn advance(own: Invocation) {
    let spot = active_ray(own);
    load_weight(spot.pixel);
    load_branches(spot.pixel);
    load_last_hit(spot.pixel, spot.index);
    // What is kept: the start of the segment under way, or of the last one. An ended ray stays there.
    var ray = load_ray(spot.pixel, spot.word);
    if !spot.alive {
        ray.status = ESCAPED;
    }
    let before = ray;
    var end = Hit(0.0, NOTHING);
    var segments = 0u;
    loop {
        work += 1u;
        follow_segments(spot, &ray, &end, &segments);
        // Those that met a surface go on from it together, when none has a segment left to its own.
        if !may_scatter(ray.status) || !spot.alive {
            break;
        }
        ray = scatter_ray(ray, &end, spot.pixel);
        if ray.status != ALIVE {
            break;
        }
    }
    finish_advance(spot, before, ray, end, own.lane);
}
