// Rays that met a surface they go on from (in the schedules that have a pass for each stage): refracted or reflected there, each
// is under way again, in the slot where its segment's end would have been.

@compute @workgroup_size(GROUP)
fn scatter(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let spot = living_pixel(group, groups, lane);
    let word = load_status(spot.pixel);
    if spot.valid && may_go_on(status_code(word)) {
        load_region(spot.pixel);
        load_weight(spot.pixel);
        load_branches(spot.pixel);
        var met = load_hit(spot.pixel);
        let next = gone_on(load_ray(spot.pixel, word), &met, spot.pixel);
        store_weight(spot.pixel);
        store_branches(spot.pixel);
        if next.status == ALIVE {
            store_ray(spot.pixel, next);
            store_region(spot.pixel);
            store_left(spot.pixel, next.index);
            store_status(spot.pixel, status_word(ALIVE, turn.end, next.index));
        } else {
            store_hit(spot.pixel, met);
            store_status(spot.pixel, status_word(next.status, status_slot(word), next.index));
        }
    }
}
