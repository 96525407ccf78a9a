// Centres with d(r) = 1/r²: singular at the centre, where steps shrink until the ray is captured or stalls.

struct InverseSquare {
    position: vec3f,
    strength: f32,
}

@group(0) @binding(51) var<uniform> inverse_square: array<InverseSquare, INVERSE_SQUARE_COUNT>;

fn inverse_square_acceleration(x: vec3f) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < INVERSE_SQUARE_COUNT; i++) {
        work += 1u;
        let d = x - inverse_square[i].position;
        let r2 = dot(d, d);
        sum -= (inverse_square[i].strength / (r2 * sqrt(r2))) * d;
    }
    return sum;
}

fn inverse_square_distance(x: vec3f) -> f32 {
    var nearest = FAR_AWAY;
    for (var i = 0u; i < INVERSE_SQUARE_COUNT; i++) {
        work += 1u;
        nearest = min(nearest, distance(x, inverse_square[i].position));
    }
    return nearest;
}
