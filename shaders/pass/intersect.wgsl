// Every segment against the scene (W04 §3.3). Run again where a walk may be suspended: what is complete is left alone.

@compute @workgroup_size(8, 8)
fn intersect(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let place = living_pixel(group, groups, lane);
    let code = status_code(load_status(place.pixel));
    if place.valid && ray_wanted(code) && walk_needed(place.pixel) {
        let hit = first_hit(load_segment(place.pixel), place.pixel);
        if code == ALIVE && !walk_suspended() {
            store_hit(place.pixel, hit);
        }
    }
}
