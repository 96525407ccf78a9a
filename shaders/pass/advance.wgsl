// K segments with all their stages in one pass (`fused`): integrate, intersect, terminate, scatter, the state through the textures
// only between passes. A pass ends at a segment's boundary, before the device's limit of loop iterations, or where a walk is
// suspended.

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
    loop {
        work += 1u;
        while segments < schedule.segments && ray.status == ALIVE {
            work += 1u;
            if work + schedule.segment_work > WORK_LIMIT {
                break;
            }
            var next = ray;
            let segment = follow_segment(&next);
            let hit = first_hit(segment, spot.pixel);
            if walk_suspended() {
                break;
            }
            let fate = segment_fate(segment, next.tau, ray.index, hit);
            forget_left();
            segments += 1u;
            if fate == ALIVE {
                next.index += 1u;
                ray = next;
            } else {
                ray.steps = next.steps;
                ray.rejected = next.rejected;
                ray.status = fate;
                // As exact as the record of hits.
                end = Hit(Real(f32(hit.t)), hit.primitive);
            }
        }
        // Those that met a surface go on from it together, when none has a segment left to its own.
        if !may_go_on(ray.status) || !alive {
            break;
        }
        ray = gone_on(ray, &end, spot.pixel);
        if ray.status != ALIVE {
            break;
        }
    }
    finish_advance(spot, alive, before, ray, end, lane);
}
