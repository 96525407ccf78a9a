// Centers with a screened (Yukawa) potential, V = −strength e^(−μr)/r: d(r) = e^(−μr)(1 + μr)/r² (W04 §5.2). Here positive strength
// attracts; the V = +ζ e^(−μr)/r of W04 repels for ζ > 0.

struct Yukawa {
    position: Real3,
    strength: Real,
    // The direction or spin that the kind of source needs, and the kind.
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
