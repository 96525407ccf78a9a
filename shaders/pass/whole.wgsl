// Follows paths in registers (`whole`): from the camera to the color in one pass, which touches no slot of the state. An invocation follows
// the paths of several pixels, one after the other, so that they share the cost of its setup. A ray that outlives the pass, before the
// device's limit of loop iterations, is counted as alive; the host then switches to `fused`.

// The counts of one invocation.
struct Counts {
    steps: u32,
    segments: u32,
    rejected: u32,
    ends: Ends,
}

@compute @workgroup_size(GROUP)
fn whole(own: Invocation) {
    var counts = Counts(0u, 0u, 0u, no_ends());
    var ray: Ray;
    let each = lane_pixels();
    if FOLLOWS_PATHS {
        // Random paths differ in length (T 4.3): a lane whose path has ended begins that of its next pixel while its neighbors continue.
        var spot: ActiveRay;
        var end: Hit;
        var segments = 0u;
        var continues = false;
        for (var k = 0u; continues || k < each;) {
            if !continues {
                spot = begin_path(lane_invocation(own, each, k), &ray);
                end = Hit(0.0, NOTHING);
                segments = 0u;
                k++;
            }
            continues = follow_leg(spot, &ray, &end, &segments);
            if !continues {
                finish_path(spot, ray, end, &counts);
            }
            count_skipped();
        }
    } else {
        for (var k = 0u; k < each; k++) {
            let spot = begin_path(lane_invocation(own, each, k), &ray);
            let end = follow_path(spot, &ray);
            finish_path(spot, ray, end, &counts);
        }
    }
    tally_steps(counts.steps);
    tally_segments(counts.segments);
    tally_rejections(counts.rejected);
    tally_ends(counts.ends);
    workgroupBarrier();
    total_statuses(own.lane);
    total_steps(own.lane);
    total_segments(own.lane);
    total_rejections(own.lane);
}

// Starts the path of an invocation's pixel. The result is valid if there is one.
fn begin_path(own: Invocation, ray: ptr<function, Ray>) -> ActiveRay {
    let place = round_pixel(own);
    *ray = path_start(place.pixel);
    clear_last_hit();
    if !place.valid {
        (*ray).status = RESTING;
    }
    let code = (*ray).status;
    return ActiveRay(place.pixel, code != RESTING, code == ALIVE, 0u, code, 0u);
}

fn finish_path(spot: ActiveRay, ray: Ray, end: Hit, counts: ptr<function, Counts>) {
    if spot.valid {
        shade_ray(spot.pixel, ray, end);
        (*counts).steps += ray.steps;
        (*counts).segments += ray.index + u32(spot.alive);
        (*counts).rejected += ray.rejected;
        (*counts).ends = with_end((*counts).ends, lit_status(ray.status, ALIVE));
    }
}
