// A segment is one accepted step.

fn follow_segment(ray: ptr<function, Ray>) -> Segment {
    let start = (*ray).phase;
    *ray = accepted_step(*ray);
    let end = (*ray).phase;
    return Segment(start[0].xyz, path_velocity(start[1].xyz), end[0].xyz, path_velocity(end[1].xyz), (*ray).taken);
}
