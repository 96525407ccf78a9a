// Centres with a screened potential, V = −strength e^(−μr)/r: d(r) = e^(−μr)(1 + μr)/r² (W04 §5.2). Here positive
// strength attracts; the paper's V = +ζ e^(−μr)/r repels for ζ > 0.

struct Yukawa {
    position: vec3f,
    strength: f32,
    mu: f32,
}

@group(0) @binding(53) var<uniform> yukawa: array<Yukawa, YUKAWA_COUNT>;

fn yukawa_acceleration(x: vec3f) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < YUKAWA_COUNT; i++) {
        work += 1u;
        let d = x - yukawa[i].position;
        let r = length(d);
        let m = yukawa[i].mu * r;
        sum -= (yukawa[i].strength * exp(-m) * (1.0 + m) / (r * r * r)) * d;
    }
    return sum;
}

fn yukawa_distance(x: vec3f) -> f32 {
    var nearest = FAR_AWAY;
    for (var i = 0u; i < YUKAWA_COUNT; i++) {
        work += 1u;
        nearest = min(nearest, distance(x, yukawa[i].position));
    }
    return nearest;
}
