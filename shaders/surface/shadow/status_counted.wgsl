// Shadows may need more work than a pass has.

// True from then on, for all that the lane still follows.
var<private> unfinished: bool;

// The path's status, or another where one of its shadows could not be found out.
fn lit_status(code: u32, otherwise: u32) -> u32 {
    return select(code, otherwise, unfinished);
}
