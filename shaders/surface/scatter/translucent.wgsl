// Handles opaque and translucent surfaces: a ray ends on an opaque one; a translucent one transmits a fraction of the light from behind, so
// that the ray both ends there and continues straight on.

struct Ending {
    // The fraction of a ray's light that comes from the surface itself; 1 if it is opaque.
    opacity: f32,
}

// One entry per material.
var<storage, read> endings: array<Ending>;

fn scatter_ending(surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let opacity = endings[surface.material].opacity;
    if opacity >= 1.0 || is_settled() {
        return Scattered(end.v, vec3f(1.0), false, false);
    }
    if KEEPS_CROSSINGS {
        add_crossing(pixel, surface, end);
    }
    let taken = chosen_branch(pixel, index, opacity);
    if taken.reflects {
        scale_throughput(vec3f(taken.throughput));
        settle();
    }
    return Scattered(end.v, vec3f(taken.throughput), taken.cut, !taken.reflects);
}

// A path that has ended by a split stays ended, however often a pass returns to its surface, and with any number of branches.
const SETTLED: u32 = 0x80000000u;

fn settle() {
    if ENUMERATES {
        branch_code |= SETTLED;
    }
}

fn is_settled() -> bool {
    if !ENUMERATES {
        return false;
    }
    return (branch_code & SETTLED) != 0u;
}
