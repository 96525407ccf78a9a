// Computes deferred local illumination (W04 §3.4, §7): once per ray, after all segments.

@compute @workgroup_size(GROUP)
fn shade(own: Invocation) {
    let spot = round_pixel(own);
    let pixel = spot.pixel;
    let followed = spot.valid && status_code(load_status(pixel)) != RESTING;
    if followed {
        load_region(pixel);
        load_throughput(pixel);
        let ray = load_ended(pixel);
        shade_ray(pixel, ray, load_hit(pixel));
        tally_status(lit_status(ray.status, EXHAUSTED));
    }
    end_round(followed, pixel, own.lane);
    total_statuses(own.lane);
}
