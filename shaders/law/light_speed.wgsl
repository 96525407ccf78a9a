// The speed of light along v in a spacetime: κ of v/κ from aκ² + 2bκ = c, where a = −g_tt, b = g_tv and c = g_vv. If no observer can be
// static, light has two speeds in some directions, of which the one nearer to v is returned, and none in others: then the result is 0 or
// not a number.

fn light_speed(a: Real, b: Real, c: Real) -> Real {
    let spread = b * b + a * c;
    let root = sqrt(spread);
    let faster = c / (b + root);
    let slower = c / (b - root);
    let slow = (a < 0.0) & (abs(slower - 1.0) < abs(faster - 1.0));
    let kappa = select(faster, slower, slow);
    // At the edge of the possible directions the two speeds meet and rounding dominates: a v that is already null stays unchanged.
    let meet = abs(spread) <= 1000.0 * LAST_PART * b * b;
    let is_light = abs(c - 2.0 * b - a) <= 10.0 * LAST_PART * (abs(c) + 2.0 * abs(b) + abs(a));
    return select(select(0.0, kappa, kappa > 0.0), 1.0, meet & is_light);
}
