// A segment, followed without asking on the way whether the path is over. An arc is followed as it is, and that is sure; the N steps of a chord
// may be written out (W04 §7): none asks whether the path is over, and none is left out. Whether it may have been is
// seen from the places in between; then the same steps are taken again, each with its test.

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
    // What is not finite stays so, and a length that is reached too.
    let sure = !all.over && finite_phase(end) && !length_reached((*ray).tau);
    return Quick(Segment(start[0].xyz, start[1].xyz, end[0].xyz, end[1].xyz, 0.0), sure);
}

// The same segment with a test before each step. Returns what it is near.
fn follow_surely(start: Ray, next: ptr<function, Ray>, segment: ptr<function, Segment>, near: u32) -> u32 {
    if !WRITES_CHORDS_OUT {
        return near;
    }
    *next = start;
    *segment = follow_segment(next);
    return nearby(*segment);
}
