// Centers with the local falloff d(r) = 2r³/R³ − 3r²/R² + 1 inside R, else 0 (G95 after Wyvill, W04 §5.2). Since d(0) = 1, the force
// reverses abruptly at the center: the scale stops shrinking at R/50, and a step beyond that meets the jump as the law has it.

struct Cubic {
    position: Real3,
    strength: Real,
    // The direction or spin that the kind of source needs, and the kind.
    along: Real3,
    kind: u32,
    radius: Real,
}

var<uniform> cubic: array<Cubic, CUBIC_COUNT>;

fn cubic_acceleration(x: Real3) -> Real3 {
    var sum = Real3(0.0);
    for (var i = 0u; i < CUBIC_COUNT; i++) {
        let d = anchor_offset(cubic[i].kind, x - cubic[i].position, cubic[i].along);
        let r = length(d);
        let q = min(r / cubic[i].radius, 1.0);
        let unit = select(d / r, Real3(0.0), r == 0.0);
        sum -= (cubic[i].strength * (q * q * (2.0 * q - 3.0) + 1.0)) * unit;
    }
    return sum;
}

fn cubic_distance(x: Real3) -> Real {
    var nearest = FAR_AWAY;
    for (var i = 0u; i < CUBIC_COUNT; i++) {
        nearest = min(nearest, max(length(anchor_offset(cubic[i].kind, x - cubic[i].position, cubic[i].along)), 0.02 * cubic[i].radius));
    }
    return nearest;
}
