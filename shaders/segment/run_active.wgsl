// Segments of rays under way: each until it ends, or the pass has had its number of them.

fn follow_segments(spot: ActiveRay, ray: ptr<function, Ray>, end: ptr<function, Hit>, segments: ptr<function, u32>) {
    while *segments < schedule.segments && (*ray).status == ALIVE {
        work += 1u;
        if work + schedule.segment_work > WORK_LIMIT {
            break;
        }
        var next = *ray;
        let segment = follow_segment(&next);
        let hit = first_hit(segment, spot.pixel);
        if walk_suspended() {
            break;
        }
        let code = segment_status(segment, next.tau, (*ray).index, hit);
        clear_last_hit();
        *segments += 1u;
        if code == ALIVE {
            next.index += 1u;
            *ray = next;
        } else {
            (*ray).steps = next.steps;
            (*ray).rejected = next.rejected;
            (*ray).status = code;
            // As exact as the record of hits.
            *end = Hit(Real(f32(hit.t)), hit.primitive);
        }
    }
}
