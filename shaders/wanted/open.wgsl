// Every pixel has the ray through its corner; samples after that are for those whose mean is not good enough yet.

fn sample_wanted(pixel: vec2u) -> bool {
    return frame.sample == 0u || (moments[place_in_tile(pixel)].state & OPEN) != 0u;
}
