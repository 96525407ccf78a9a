// K segments with all their stages in one pass (`fused`): integrate, intersect, terminate, the state through the textures only
// between passes. A pass ends at a segment's boundary, before the device's limit of loop iterations, or where a walk is suspended.

@compute @workgroup_size(8, 8)
fn advance(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let spot = living_pixel(group, groups, lane);
    let word = load_status(spot.pixel);
    let alive = spot.valid && status_code(word) == ALIVE;
    load_region(spot.pixel);
    load_left(spot.pixel, status_index(word));
    // What is kept: the start of the segment under way, or of the last one. An ended ray stays there.
    var ray = load_ray(spot.pixel, word);
    if !alive {
        ray.status = ESCAPED;
    }
    let before = ray;
    var end = Hit(0.0, NOTHING);
    // What runs on: the same as long as the ray lives.
    var path = ray;
    for (var n = 0u; n < schedule.segments && spot.valid && ray_wanted(ray.status); n++) {
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
        if ray.status == ALIVE {
            ray.steps = next.steps;
            ray.rejected = next.rejected;
            ray.status = fate;
            if fate == ALIVE {
                ray = next;
            } else {
                end = hit;
            }
        }
        path = next;
    }
    let lives = alive && ray.status == ALIVE;
    if alive {
        store_ray(spot.pixel, ray);
        store_counts(spot.pixel, ray);
        store_status(spot.pixel, status_word(word, ray.status, turn.end, ray.index));
        if ray.status == HIT {
            store_hit(spot.pixel, end);
        }
    }
    let segments = select(0u, ray.index - before.index + u32(!lives), alive);
    tally_steps(ray.steps - before.steps, lane);
    tally_segments(segments, lane);
    tally_rejections(ray.rejected - before.rejected, lane);
    keep_living(lives || (alive && goes_on(ray.status)), spot.pixel, lane);
}
