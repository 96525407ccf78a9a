// A ray that was reflected by a flat mirror cannot meet it again in the segment that starts there, wherever rounding puts that
// start. What it left is the last hit of its record, whose fraction is then the index of the segment that starts on it.

var<private> left: u32;

fn load_left(pixel: vec2u, index: u32) {
    let last = load_hit(pixel);
    left = select(NOTHING, last.primitive, last.t == Real(index));
}

fn forget_left() {
    left = NOTHING;
}

fn just_left(primitive: u32) -> bool {
    return primitive == left;
}
