// All shapes are in the structure.

fn listed_hit(s: Segment, pieces: u32, near: u32) -> Hit {
    return Hit(2.0, NOTHING);
}
