// Runs K segments with all their stages in one pass (`fused`): integrate, intersect, terminate, scatter. The slots of the state are used
// only between passes. A pass ends at the boundary of a segment, before the device's limit of loop iterations, or where a walk is
// suspended.

@compute @workgroup_size(GROUP)
fn advance(own: Invocation) {
    let spot = active_ray(own);
    load_throughput(spot.pixel);
    if AIMS {
        load_waiting(spot.pixel);
    }
    load_branches(spot.pixel);
    load_last_hit(spot.pixel, spot.index);
    var ray = load_ray(spot.pixel, spot.word);
    if !spot.alive {
        ray.status = ESCAPED;
    }
    let before = ray;
    let end = follow_path(spot, &ray);
    finish_advance(spot, before, ray, end, own.lane);
}
