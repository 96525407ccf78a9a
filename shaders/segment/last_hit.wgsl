// Stores the surface that a ray left: a ray reflected by a flat mirror cannot meet it again in the segment that starts there, wherever
// rounding puts that start. Between passes the surface is in the stored hit, whose fraction is then the index of the segment that starts on
// it.

var<private> last_primitive: u32;

fn load_last_hit(pixel: vec2u, index: u32) {
    if KEEPS_LAST_HIT {
        let last = load_hit(pixel);
        last_primitive = select(NOTHING, last.primitive, last.t == Real(index));
    }
}

fn store_last_hit(pixel: vec2u, index: u32) {
    if KEEPS_LAST_HIT {
        if last_primitive != NOTHING {
            store_hit(pixel, Hit(Real(index), last_primitive));
        }
    }
}

fn set_last_hit(primitive: u32) {
    if KEEPS_LAST_HIT {
        last_primitive = primitive;
    }
}

fn clear_last_hit() {
    if KEEPS_LAST_HIT {
        last_primitive = NOTHING;
    }
}

fn is_last_hit(primitive: u32) -> bool {
    if !KEEPS_LAST_HIT {
        return false;
    }
    return primitive == last_primitive;
}
