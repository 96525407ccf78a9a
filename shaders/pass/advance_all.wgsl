// As pass/advance.wgsl, with ended rays run along, for the comparison with masks: what runs on beside the ray that is kept is twice
// the state. Where a ray may go on from a surface it waits there.

@compute @workgroup_size(GROUP)
fn advance(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let spot = living_pixel(group, groups, lane);
    let word = load_status(spot.pixel);
    let alive = spot.valid && status_code(word) == ALIVE;
    load_region(spot.pixel);
    load_weight(spot.pixel);
    load_branches(spot.pixel);
    load_left(spot.pixel, status_index(word));
    // What is kept: the start of the segment under way, or of the last one. An ended ray stays there.
    var ray = load_ray(spot.pixel, word);
    if !alive {
        ray.status = ESCAPED;
    }
    let before = ray;
    var end = Hit(0.0, NOTHING);
    var segments = 0u;
    // What runs on: the same as long as the ray lives.
    var path = ray;
    loop {
        work += 1u;
        while segments < schedule.segments && spot.valid && !may_go_on(ray.status) {
            work += 1u;
            if work + schedule.segment_work > WORK_LIMIT {
                break;
            }
            var next = path;
            let segment = follow_segment(&next);
            let hit = first_hit(segment, spot.pixel);
            if walk_suspended() {
                break;
            }
            let fate = segment_fate(segment, next.tau, path.index, hit);
            forget_left();
            next.index += 1u;
            segments += 1u;
            if ray.status == ALIVE {
                ray.steps = next.steps;
                ray.rejected = next.rejected;
                ray.status = fate;
                if fate == ALIVE {
                    ray = next;
                } else {
                    // As exact as the record of hits.
                    end = Hit(Real(f32(hit.t)), hit.primitive);
                }
            }
            path = next;
        }
        // Those that met a surface go on from it together, when none has a segment left to its own.
        if !may_go_on(ray.status) || !alive {
            break;
        }
        ray = gone_on(ray, &end, spot.pixel);
        path = ray;
        if ray.status != ALIVE {
            break;
        }
    }
    finish_advance(spot, alive, before, ray, end, lane);
}
