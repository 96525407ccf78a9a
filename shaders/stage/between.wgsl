// A segment between two slots of the state, for the schedules that integrate and intersect in different passes.

fn load_segment(pixel: vec2u) -> Segment {
    return Segment(start_x(pixel).xyz, start_v(pixel).xyz, end_x(pixel).xyz, end_v(pixel).xyz, taken_step(pixel));
}

fn load_tau(pixel: vec2u) -> Real {
    return end_x(pixel).w;
}
