// How far to go in place of a piece that disagrees with its halves: half of it, but wrapped textures jump, where every rule is of first order and halving would need a piece for each bit. So a jump is looked for, and a
// piece ends at it. Between jumps the texture is smooth: false position, with the Illinois rule (Dowell and Jarratt 1971), finds in some
// seven looks what bisection finds in twenty.

const JUMP_LOOKS: u32 = 22u;
// In parts of a piece: how far from its ends is looked first, and how well a jump's place is known.
const BESIDE_JUMP: Real = 1e-6;

// How often a texture has wrapped at a place, and the part of the next time.
fn turns_at(filter_at: Filter, p: Phase, h: Real) -> Real {
    if filter_at.kind != WRAPPED {
        return 0.0;
    }
    return Real(filter_at.times * texture_share(filter_at, texture_sum(filter_at, place_in_filter(filter_at, p, h))));
}

fn smaller_piece(filter_at: Filter, p: Phase, a: Real, own: Real) -> Real {
    if !FILTERS_JUMP {
        return 0.5 * own;
    }
    let beside = BESIDE_JUMP * own;
    var before = beside;
    var behind = own - beside;
    var wraps: Real = 0.0;
    // The turns at both, from those at the first jump between them.
    var level: Real = 0.0;
    var near: Real = 0.0;
    var far: Real = 0.0;
    // Which of the two the last look has moved.
    var moved = 0u;
    // Both ends first, in the same loop: what looks is written out once, for it is long.
    for (var i = 0u; i < JUMP_LOOKS && behind - before > 1.5 * beside; i++) {
        let slope = near - far;
        let line = before + (behind - before) * near / select(slope, 1.0, slope == 0.0);
        let between = clamp(line, before + beside, max(behind - beside, before + beside));
        let at = select(select(between, behind, i == 1u), before, i == 0u);
        let turns = turns_at(filter_at, p, a + at);
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
