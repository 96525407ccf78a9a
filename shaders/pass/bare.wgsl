// Takes a given number of steps of every ray in registers and does nothing else: no segments, no tests for their end, no masks. `bench
// limit` compares the schedules with it.

var<storage, read> wanted_steps: array<u32>;

@compute @workgroup_size(GROUP)
fn bare(own: Invocation) {
    let spot = grid_pixel(own);
    let word = load_status(spot.pixel);
    load_region(spot.pixel);
    let wanted = wanted_steps[place_in_tile(spot.pixel)];
    let ray = bare_steps(load_ray(spot.pixel, word), select(0u, wanted, spot.valid));
    if spot.valid {
        store_ray(spot.pixel, ray);
        store_counts(spot.pixel, ray);
    }
}
