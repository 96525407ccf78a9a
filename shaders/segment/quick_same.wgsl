// A segment is followed as it is, and that is sure.

fn follow_quickly(ray: ptr<function, Ray>) -> Quick {
    return Quick(follow_segment(ray), true);
}

fn follow_surely(start: Ray, next: ptr<function, Ray>, segment: ptr<function, Segment>, near: u32) -> u32 {
    return near;
}
