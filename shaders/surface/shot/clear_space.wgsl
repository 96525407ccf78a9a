// There is nothing that could cast a shadow.

fn shot_clear(source: Real3, d: Real3, place: Real3) -> bool {
    return true;
}
