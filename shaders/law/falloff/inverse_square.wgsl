// Centers with d(r) = 1/r²: singular at the center, where steps shrink until the ray is captured or stalls.

struct InverseSquare {
    position: Real3,
    strength: Real,
    // The direction or spin that the kind of source needs, and the kind.
    along: Real3,
    kind: u32,
}

var<uniform> inverse_square: array<InverseSquare, INVERSE_SQUARE_COUNT>;

fn inverse_square_acceleration(x: Real3) -> Real3 {
    var sum = Real3(0.0);
    for (var i = 0u; i < INVERSE_SQUARE_COUNT; i++) {
        let d = anchor_offset(inverse_square[i].kind, x - inverse_square[i].position, inverse_square[i].along);
        let r2 = dot(d, d);
        sum -= (inverse_square[i].strength / (r2 * sqrt(r2))) * d;
    }
    return sum;
}

fn inverse_square_distance(x: Real3) -> Real {
    var nearest = FAR_AWAY;
    for (var i = 0u; i < INVERSE_SQUARE_COUNT; i++) {
        nearest = min(nearest, length(anchor_offset(inverse_square[i].kind, x - inverse_square[i].position, inverse_square[i].along)));
    }
    return nearest;
}
