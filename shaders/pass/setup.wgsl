// Sets up rays (W04 §3.1): writes the camera's rays to the first slot of the state.

@compute @workgroup_size(GROUP)
fn setup(own: Invocation) {
    let spot = round_pixel(own);
    let pixel = spot.pixel;
    let ray = path_start(pixel);
    if spot.valid {
        store_region(pixel);
        store_throughput(pixel);
        store_branches(pixel);
        store_ray(pixel, ray);
        store_counts(pixel, ray);
        store_status(pixel, status_word(ray.status, 0u, 0u));
        clear_hit(pixel);
    }
}
