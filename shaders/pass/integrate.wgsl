// One segment of every ray (`segment`): N steps inside.

@compute @workgroup_size(GROUP)
fn integrate(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let spot = living_pixel(group, groups, lane);
    let word = load_status(spot.pixel);
    let alive = spot.valid && status_code(word) == ALIVE;
    load_region(spot.pixel);
    let ray = load_ray(spot.pixel, word);
    var next = ray;
    if ray_wanted(status_code(word)) {
        let segment = follow_segment(&next);
    }
    if alive {
        store_ray(spot.pixel, next);
        store_counts(spot.pixel, next);
        store_taken(spot.pixel, next.taken);
        tally_steps(next.steps - ray.steps);
        tally_rejections(next.rejected - ray.rejected);
    }
    workgroupBarrier();
    total_steps(lane);
    total_rejections(lane);
}
