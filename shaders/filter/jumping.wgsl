// Wrapped textures jump, where every rule is of first order and halving would need a piece for each bit. So a jump is looked for, by
// bisection, and a piece ends at it.

const JUMP_HALVINGS: u32 = 22u;
// Beside a jump, in parts of a piece.
const BESIDE_JUMP: Real = 1e-6;

// How often a texture has wrapped at a place.
fn wraps_at(filter_at: Filter, p: Phase, h: Real) -> f32 {
    if filter_at.kind != WRAPPED {
        return 0.0;
    }
    return floor(filter_at.times * texture_share(filter_at, place_in_filter(filter_at, p, h)));
}

fn smaller_piece(filter_at: Filter, p: Phase, a: Real, own: Real) -> Real {
    let here_wraps = wraps_at(filter_at, p, a + BESIDE_JUMP * own);
    if wraps_at(filter_at, p, a + (1.0 - BESIDE_JUMP) * own) == here_wraps {
        return 0.5 * own;
    }
    var before = BESIDE_JUMP * own;
    var behind = own;
    for (var i = 0u; i < JUMP_HALVINGS; i++) {
        work += 1u;
        let middle = 0.5 * (before + behind);
        let same = wraps_at(filter_at, p, a + middle) == here_wraps;
        before = select(before, middle, same);
        behind = select(middle, behind, same);
    }
    return before;
}
