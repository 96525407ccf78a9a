// How light is looked for from surfaces: where that begins, what is met first, and whether it could be found out.

// In parts of the numbers that its place was computed from: further than rounding moves it.
const OFF: Real = 8e-6;

// Where light that a surface sends to the viewer has come from: a little off it, on the viewer's side, if a line or path begins there.
fn lit_from(x: Real3, surface: Surface, view: vec3f) -> Real3 {
    if !LEAVES_SURFACES {
        return x;
    }
    let off = OFF * (length(x) + surface.depth);
    return x + select(-off, off, dot(vec3f(surface.across), view) >= 0.0) * surface.across;
}

// True once a shadow has needed more work than a pass has, for all that the lane still follows.
var<private> unfinished: bool;

// The path's status, or another where one of its shadows could not be found out.
fn lit_status(code: u32, otherwise: u32) -> u32 {
    if !LOOKS_FOR_LIGHT {
        return code;
    }
    return select(code, otherwise, unfinished);
}

// True while a line to a light is followed: it ends there, and pieces of a path go on beyond their ends.
var<private> along_light: bool;

fn mark_line(begins: bool) {
    if !JOINS_WHOLE {
        along_light = begins;
    }
}

// What a line or path meets first on one segment.
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
