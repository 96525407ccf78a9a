// Ray setup (W04 §3.1): the camera's rays into the first slot of the state.

@compute @workgroup_size(GROUP)
fn setup(own: Invocation) {
    let spot = round_pixel(own);
    let pixel = spot.pixel;
    let start = arrived(picture_ray(sampled_pixel(pixel)));
    start_region(start.x, start.d, pixel);
    let phase = law_start(start.x, start.d);
    var ray = Ray(phase, 0.0, first_memory(phase), 0.0, 0u, 0u, 0u, start.status);
    if ray.status == ALIVE && law_captured(phase[0].xyz, phase[1].xyz) {
        ray.status = CAPTURED;
    }
    if ray.status != OUTSIDE && (!finite(phase[0].xyz) || !finite(phase[1].xyz)) {
        ray.status = FAILED;
    }
    if spot.valid && !(sample_wanted(pixel) && begin_branches(pixel)) {
        ray.status = RESTING;
    }
    if spot.valid {
        start_weight(phase[0].xyz);
        store_region(pixel);
        store_weight(pixel);
        store_branches(pixel);
        store_ray(pixel, ray);
        store_counts(pixel, ray);
        store_status(pixel, status_word(ray.status, 0u, 0u));
        clear_hit(pixel);
    }
}
