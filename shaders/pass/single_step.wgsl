// Takes one integration step of every ray (`paper`: W04 §3.2 has one pass for each).

@compute @workgroup_size(GROUP)
fn single_step(own: Invocation) {
    let spot = active_ray(own);
    let ray = load_ray(spot.pixel, spot.word);
    var next = ray;
    if ray_wanted(spot.code) && !path_over(ray) {
        if TRANSFERS_ORBITS {
            next = lit_segment(spot.pixel, ray);
        } else {
            next = accepted_step(ray);
        }
    }
    finish_steps(spot, ray, next, own.lane);
}
