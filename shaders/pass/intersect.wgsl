// Every segment against the scene (W04 §3.3). Run again where a walk may be suspended: what is complete is left alone.

@compute @workgroup_size(GROUP)
fn intersect(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let spot = living_pixel(group, groups, lane);
    let word = load_status(spot.pixel);
    let code = status_code(word);
    load_region(spot.pixel);
    load_left(spot.pixel, status_index(word));
    if spot.valid && ray_wanted(code) && walk_needed(spot.pixel) {
        let hit = first_hit(load_segment(spot.pixel), spot.pixel);
        if code == ALIVE && !walk_suspended() {
            store_hit(spot.pixel, hit);
        }
    }
}
