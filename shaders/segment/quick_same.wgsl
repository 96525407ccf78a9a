// A segment is followed as it is, and that is sure.

struct Quick {
    segment: Segment,
    // False where the path may have been over before the segment's end.
    sure: bool,
}

fn follow_quickly(ray: ptr<function, Ray>) -> Quick {
    return Quick(follow_segment(ray), true);
}

fn follow_surely(start: Ray, next: ptr<function, Ray>, quick: Quick, segment: ptr<function, Segment>, near: u32) -> u32 {
    return near;
}
