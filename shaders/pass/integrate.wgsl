// Integrates one segment of every ray (`segment`), with N steps inside.

@compute @workgroup_size(GROUP)
fn integrate(own: Invocation) {
    let spot = active_ray(own);
    let ray = load_ray(spot.pixel, spot.word);
    var next = ray;
    if ray_wanted(spot.code) {
        if TRANSFERS_ORBITS {
            next = lit_segment(spot.pixel, ray);
        } else {
            let segment = follow_segment(&next);
        }
    }
    finish_steps(spot, ray, next, own.lane);
}
