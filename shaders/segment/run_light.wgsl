// Segments of rays from a light, which leave their light in the voxels on their way.

fn follow_segments(spot: ActiveRay, ray: ptr<function, Ray>, end: ptr<function, Hit>, segments: ptr<function, u32>) {
    while (*ray).status == ALIVE {
        if *segments >= schedule.segments || !has_room() {
            break;
        }
        var next = *ray;
        let segment = follow_segment(&next);
        let hit = first_hit(segment, nearby(segment), spot.pixel);
        if walk_suspended() || overran(*segments) {
            break;
        }
        let code = known_status(segment_status(segment, next.tau, (*ray).index, hit));
        clear_last_hit();
        *segments += 1u;
        leave_light(segment, select(1.0, hit.t, hit.primitive != NOTHING), light_weight());
        if code == ALIVE {
            if FILTERS {
                filter_step(*ray, next);
            }
            next.index += 1u;
            *ray = next;
        } else {
            (*ray).steps = next.steps;
            (*ray).rejected = next.rejected;
            (*ray).status = code;
            // As exact as the record of hits.
            *end = Hit(Real(f32(hit.t)), hit.primitive);
        }
        rejoin();
    }
    if spot.valid {
        keep_reach(spot.pixel);
    }
}
