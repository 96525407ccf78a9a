// Follows paths in registers (`whole`): from the camera to the color in one pass, which touches no slot of the state. An invocation follows
// the paths of several pixels, one after the other, so that they share the cost of its setup. A ray that outlives the pass, before the
// device's limit of loop iterations, is counted as alive; the host then switches to `fused`.

@compute @workgroup_size(GROUP)
fn whole(own: Invocation) {
    var steps = 0u;
    var segments = 0u;
    var rejected = 0u;
    var ends = no_ends();
    let each = lane_pixels();
    for (var k = 0u; k < each; k++) {
        let place = round_pixel(lane_invocation(own, each, k));
        let pixel = place.pixel;
        var ray = path_start(pixel);
        clear_last_hit();
        let followed = place.valid && ray.status != RESTING;
        let spot = ActiveRay(pixel, place.valid, followed && ray.status == ALIVE, 0u, ray.status, 0u);
        if !followed {
            ray.status = RESTING;
        }
        let end = follow_path(spot, &ray);
        if followed {
            shade_ray(pixel, ray, end);
            steps += ray.steps;
            segments += ray.index + u32(spot.alive);
            rejected += ray.rejected;
            ends = with_end(ends, lit_status(ray.status, ALIVE));
        }
    }
    tally_steps(steps);
    tally_segments(segments);
    tally_rejections(rejected);
    tally_ends(ends);
    workgroupBarrier();
    total_statuses(own.lane);
    total_steps(own.lane);
    total_segments(own.lane);
    total_rejections(own.lane);
}
