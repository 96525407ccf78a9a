// Locates the jumps of wrapped textures. At a jump every rule is of first order, and halving would need a piece for each bit, so that a piece
// ends there. Between jumps the texture is smooth: false position with the Illinois rule (Dowell and Jarratt 1971) finds in about seven
// evaluations a position for which bisection needs twenty.

const JUMP_LOOKS: u32 = 22u;
// The distance from its ends of the first evaluations, and the accuracy of a jump's position, as fractions of a piece.
const BESIDE_JUMP: Real = 1e-6;

// Returns the number of times that a texture has wrapped at a fraction of a step, with the fraction of the next turn.
fn turns_at(step: Stretch, f: Real) -> Real {
    if absorption.kind != WRAPPED {
        return 0.0;
    }
    let sum = texture_sum(absorption, stretch_place(step, f) - absorption.center);
    return Real(absorption.times * texture_share(absorption, sum));
}

// Returns the distance from the start of a piece to its first jump, or half its size.
fn size_to_jump(step: Stretch, a: Real, own: Real) -> Real {
    let beside = BESIDE_JUMP * own;
    var before = beside;
    var behind = own - beside;
    var wraps: Real = 0.0;
    // The turns at both ends, relative to the first jump between them.
    var level: Real = 0.0;
    var near: Real = 0.0;
    var far: Real = 0.0;
    // The end that the last evaluation moved.
    var moved = 0u;
    // Both ends come first, in the same loop: the evaluation is long, so that it should be in the program once.
    for (var i = 0u; i < JUMP_LOOKS && behind - before > 1.5 * beside; i++) {
        let slope = near - far;
        let line = before + (behind - before) * near / select(slope, 1.0, slope == 0.0);
        let between = clamp(line, before + beside, max(behind - beside, before + beside));
        let at = select(select(between, behind, i == 1u), before, i == 0u);
        let turns = turns_at(step, a + at);
        if i == 0u {
            wraps = floor(turns);
            near = turns;
        } else if i == 1u {
            if floor(turns) == wraps {
                return 0.5 * own;
            }
            level = select(wraps, wraps + 1.0, turns > near);
            near -= level;
            far = turns - level;
        } else if floor(turns) == wraps {
            before = at;
            near = turns - level;
            // A side that has stayed twice counts half.
            far *= select(Real(1.0), 0.5, moved == 1u);
            moved = 1u;
        } else {
            behind = at;
            far = turns - level;
            near *= select(Real(1.0), 0.5, moved == 2u);
            moved = 2u;
        }
    }
    return before;
}
