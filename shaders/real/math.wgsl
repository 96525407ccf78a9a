// What holds in every precision.

const PI = 3.14159265358979323846;

// The next time that something periodic comes by: an angle in [0, 2π), or 0 where it is passed at once.
fn next_turn(angle: Real, now: bool) -> Real {
    let turn = angle - floor(angle / (2.0 * PI)) * (2.0 * PI);
    return select(turn, 0.0, now);
}
