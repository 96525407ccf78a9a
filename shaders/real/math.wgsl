// Functions that do not depend on the precision.

const PI = 3.14159265358979323846;

// Returns the angle until the next passage of a periodic position: in [0, 2π), or 0 if it passes at once.
fn next_turn(angle: Real, now: bool) -> Real {
    let turn = angle - floor(angle / (2.0 * PI)) * (2.0 * PI);
    return select(turn, 0.0, now);
}
