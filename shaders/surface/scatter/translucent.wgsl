// Surfaces that end rays, and some through which a part of the light from behind comes: such a ray both ends there and goes straight on.

struct Ending {
    // The part of a ray's light that is the surface's own; 1 where it is opaque.
    opacity: f32,
}

// By material.
var<storage, read> endings: array<Ending>;

fn scatter_ending(surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let opacity = endings[surface.material].opacity;
    if opacity >= 1.0 || is_settled() {
        return Scattered(end.v, vec3f(1.0), false, false);
    }
    let taken = chosen_branch(pixel, index, opacity);
    if taken.reflects {
        scale_weight(vec3f(taken.weight));
        settle();
    }
    return Scattered(end.v, vec3f(taken.weight), taken.cut, !taken.reflects);
}

// A path that has ended by a branching stays ended, however often a pass comes back to its surface, and among however many branches.
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
