// Nothing is in a structure.

fn structure_hit(s: Segment, pieces: u32, nearest: Hit) -> Hit {
    return nearest;
}
