// A path in registers (`whole`): from the camera to its colour in one pass, which touches no texture of the state. A ray that outlives
// the pass, before the device's limit of loop iterations, is counted as alive; the host then goes over to `fused`.

@compute @workgroup_size(GROUP)
fn whole(own: Invocation) {
    let place = round_pixel(own);
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
        tally_steps(ray.steps);
        tally_segments(ray.index + u32(spot.alive));
        tally_rejections(ray.rejected);
    }
    end_round(followed, pixel, own.lane);
    total_statuses(own.lane);
    total_steps(own.lane);
    total_segments(own.lane);
    total_rejections(own.lane);
}
