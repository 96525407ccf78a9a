// A ray that was reflected by a flat mirror cannot meet it again in the segment that starts there, wherever rounding puts that
// start. Between passes what it left is in the record of its hits, whose fraction is then the index of the segment that starts
// on it.

var<private> left: u32;

fn load_left(pixel: vec2u, index: u32) {
    let last = load_hit(pixel);
    left = select(NOTHING, last.primitive, last.t == Real(index));
}

fn store_left(pixel: vec2u, index: u32) {
    if left != NOTHING {
        store_hit(pixel, Hit(Real(index), left));
    }
}

fn leave_surface(primitive: u32) {
    left = primitive;
}

fn forget_left() {
    left = NOTHING;
}

fn just_left(primitive: u32) -> bool {
    return primitive == left;
}
