// Follows segments of active rays: each until it ends, or until the pass has done its number of them.
//
// Segments that nothing is near and that end no path are followed in a separate loop, which does nothing else. Rays from a light
// deposit it in the voxels on their way.

fn follow_segments(spot: ActiveRay, ray: ptr<function, Ray>, end: ptr<function, Hit>, segments: ptr<function, u32>) {
    if TRANSFERS {
        begin_transfer(spot.pixel);
    }
    while (*ray).status == ALIVE {
        var next = *ray;
        var quick: Quick;
        var near = 0u;
        var full = false;
        loop {
            full = *segments >= schedule.segments || !has_room();
            if full {
                break;
            }
            next = *ray;
            if TRAVELS {
                note_segment(next.tau);
            }
            quick = follow_quickly(&next);
            near = nearby(quick.segment);
            if !quick.sure || near != 0u || is_spent() || open_status(quick.segment, next.tau, (*ray).index) != ALIVE {
                break;
            }
            clear_last_hit();
            if LEAVES_LIGHT {
                note_weight();
            }
            if TRANSFERS {
                transfer_passed(*ray, next, 1.0);
            }
            if LEAVES_LIGHT {
                leave_light(quick.segment, 1.0);
            }
            if KEEPS_LENGTH {
                add_length(spot.pixel, (*ray).phase, next.phase[0].xyz, next.phase[1].xyz);
            }
            *segments += 1u;
            next.index += 1u;
            *ray = next;
        }
        walk_turn();
        if full {
            break;
        }
        var segment = quick.segment;
        near = follow_surely(*ray, &next, &segment, near);
        let hit = first_hit(segment, near, spot.pixel);
        if walk_suspended() || overran(*segments) {
            break;
        }
        let code = known_status(segment_status(segment, next.tau, (*ray).index, hit));
        clear_last_hit();
        *segments += 1u;
        if LEAVES_LIGHT {
            let until = select(1.0, hit.t, hit.primitive != NOTHING);
            let kept = kept_throughput();
            note_weight();
            if TRANSFERS {
                transfer_passed(*ray, next, until);
            }
            leave_light(segment, until);
            // The light of a last segment is weakened once more where it ends.
            if code != ALIVE {
                restore_throughput(kept);
            }
        }
        if code == ALIVE {
            if TRANSFERS {
                if !LEAVES_LIGHT {
                    transfer_passed(*ray, next, 1.0);
                }
            }
            if KEEPS_LENGTH {
                add_length(spot.pixel, (*ray).phase, next.phase[0].xyz, next.phase[1].xyz);
            }
            next.index += 1u;
            *ray = next;
        } else {
            (*ray).steps = next.steps;
            (*ray).rejected = next.rejected;
            (*ray).status = code;
            if KEEPS_LAST {
                keep_end(next);
            }
            // Rounded to the precision of the stored hits.
            *end = Hit(Real(f32(hit.t)), hit.primitive);
        }
        rejoin();
    }
    if TRANSFERS {
        if spot.valid {
            keep_transfer(spot.pixel);
        }
    }
    if LEAVES_LIGHT {
        if spot.valid {
            keep_reach(spot.pixel);
        }
    }
}
