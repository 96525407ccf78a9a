// Follows segments of every ray, including ended ones, for the comparison with masks: next to the stored ray another copy of the state runs
// on. A ray that may continue from a surface waits there.

fn follow_segments(spot: ActiveRay, ray: ptr<function, Ray>, end: ptr<function, Hit>, segments: ptr<function, u32>) {
    // The state that runs on: equal to the ray as long as that is alive.
    var path = *ray;
    if TRANSFERS {
        begin_transfer(spot.pixel);
    }
    while *segments < schedule.segments && spot.valid && !may_scatter((*ray).status) {
        if !has_room() {
            break;
        }
        var next = path;
        if TRAVELS {
            note_segment(next.tau);
        }
        if TRANSFERS_ORBITS {
            follows_ended = (*ray).status != ALIVE;
        }
        let segment = follow_segment(&next);
        let hit = first_hit(segment, nearby(segment), spot.pixel);
        if walk_suspended() || overran(*segments) {
            break;
        }
        let code = known_status(segment_status(segment, next.tau, path.index, hit));
        clear_last_hit();
        next.index += 1u;
        *segments += 1u;
        if (*ray).status == ALIVE {
            (*ray).steps = next.steps;
            (*ray).rejected = next.rejected;
            (*ray).status = code;
            if code == ALIVE {
                if TRANSFERS {
                    transfer_passed(*ray, next, 1.0);
                }
                if KEEPS_LENGTH {
                    add_length(spot.pixel, (*ray).phase, next.phase[0].xyz, next.phase[1].xyz);
                }
                *ray = next;
            } else {
                if KEEPS_LAST {
                    keep_end(next);
                }
                // Rounded to the precision of the stored hits.
                *end = Hit(Real(f32(hit.t)), hit.primitive);
            }
        }
        path = next;
        rejoin();
    }
    if TRANSFERS {
        if spot.valid {
            keep_transfer(spot.pixel);
        }
    }
}
