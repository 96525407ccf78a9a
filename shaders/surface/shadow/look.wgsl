// Follows shadow rays from surfaces: their start, their first hit, and whether the result is complete.

// Relative to the numbers that its position was computed from: further than rounding moves it.
const OFF: Real = 8e-6;

// Returns the origin of shadow rays for light that a surface sends to the viewer: slightly off it, on the viewer's side, if a line or path
// begins there.
fn lit_from(x: Real3, surface: Surface, view: vec3f) -> Real3 {
    if !LEAVES_SURFACES {
        return x;
    }
    let off = OFF * (length(x) + surface.depth);
    return x + select(-off, off, dot(vec3f(surface.normal), view) >= 0.0) * surface.normal;
}

// True once a shadow has needed more work than a pass allows, for the rest of the lane.
var<private> unfinished: bool;

// Returns the status of the path, or `otherwise` if one of its shadows is incomplete.
fn lit_status(code: u32, otherwise: u32) -> u32 {
    if !LOOKS_FOR_LIGHT {
        return code;
    }
    return select(code, otherwise, unfinished);
}

// True while a line to a light is followed: it ends there, while pieces of a path extend beyond their ends.
var<private> along_light: bool;

fn mark_line(begins: bool) {
    if !JOINS_WHOLE {
        along_light = begins;
    }
}

// Returns the first hit of a line or path on one segment.
fn first_met(s: Segment, pieces: u32) -> Hit {
    let near = items_near(s);
    var hit = listed_hit(s, pieces, near);
    walk_anew();
    if HAS_STRUCTURE {
        hit = structure_hit(s, select(0u, pieces, (near & NEAR_STRUCTURE) != 0u), hit);
    }
    unfinished = unfinished || walk_suspended();
    return hit;
}
