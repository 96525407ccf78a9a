// Centres with a screened potential, V = −strength e^(−μr)/r: d(r) = e^(−μr)(1 + μr)/r² (W04 §5.2). Here positive
// strength attracts; the paper's V = +ζ e^(−μr)/r repels for ζ > 0.

struct Yukawa {
    position: Real3,
    strength: Real,
    // What its kind has besides a position, and its kind.
    along: Real3,
    kind: u32,
    mu: Real,
}

var<uniform> yukawa: array<Yukawa, YUKAWA_COUNT>;

fn yukawa_acceleration(x: Real3) -> Real3 {
    var sum = Real3(0.0);
    for (var i = 0u; i < YUKAWA_COUNT; i++) {
        let d = anchor_offset(yukawa[i].kind, x - yukawa[i].position, yukawa[i].along);
        let r = length(d);
        let m = yukawa[i].mu * r;
        sum -= (yukawa[i].strength * real_exp(-m) * (1.0 + m) / (r * r * r)) * d;
    }
    return sum;
}

fn yukawa_distance(x: Real3) -> Real {
    var nearest = FAR_AWAY;
    for (var i = 0u; i < YUKAWA_COUNT; i++) {
        nearest = min(nearest, length(anchor_offset(yukawa[i].kind, x - yukawa[i].position, yukawa[i].along)));
    }
    return nearest;
}
