// Follows a segment without testing on the way whether the path is over. An arc is always valid; the N steps of a chord may be unrolled
// (W04 §7), without a test between them. The positions in between show whether the path may have been over; then the same steps are
// retaken, each with its test.

// A ray after all steps of a chord, and whether its path may have been over before.
struct ChordSteps {
    ray: Ray,
    over: bool,
}

fn may_be_over(ray: Ray) -> bool {
    let x = ray.phase[0].xyz;
    return outside_bound(x) | inside_capture(x);
}

fn follow_quickly(ray: ptr<function, Ray>) -> Quick {
    if !WRITES_CHORDS_OUT {
        return Quick(follow_segment(ray), true);
    }
    let start = (*ray).phase;
    let all = chord_steps(*ray);
    *ray = all.ray;
    let end = (*ray).phase;
    // A state that is not finite stays so, and so does a length that is reached.
    let sure = !all.over && finite_phase(end) && !length_reached((*ray).tau);
    return Quick(Segment(start[0].xyz, start[1].xyz, end[0].xyz, end[1].xyz, 0.0), sure);
}

// Follows the same segment with a test before each step, and returns the bits of the objects near it.
fn follow_surely(start: Ray, next: ptr<function, Ray>, segment: ptr<function, Segment>, near: u32) -> u32 {
    if !WRITES_CHORDS_OUT {
        return near;
    }
    *next = start;
    *segment = follow_segment(next);
    return nearby(*segment);
}
