// The next time that something periodic comes by.

// An angle in [0, 2π); 0 where it is passed at once.
fn next_turn(angle: Real, now: bool) -> Real {
    let turn = angle - floor(angle / (2.0 * PI)) * (2.0 * PI);
    return select(turn, 0.0, now);
}
