// Ray setup (W04 §3.1): the camera's rays into the first slot of the state.

@compute @workgroup_size(8, 8)
fn setup(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let pixel = group.xy * vec2u(8u) + vec2u(lane % 8u, lane / 8u);
    let valid = all(pixel < frame.size);
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
    if valid && !begin_branches(pixel) {
        ray.status = RESTING;
    }
    if valid {
        store_region(pixel);
        start_weight(pixel, phase[0].xyz);
        store_ray(pixel, ray);
        store_counts(pixel, ray);
        store_status(pixel, status_word(ray.status, 0u, 0u));
        clear_hit(pixel);
    }
    keep_living(valid && ray.status == ALIVE, pixel, lane);
}
