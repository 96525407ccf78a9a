// A segment's walk over the scene's structure may need more iterations than a pass has, and no later pass goes on with it: where the
// work runs out the ray stays alive, and the host follows it by other passes.

var<private> walk_stopped: bool;

// There is room for the next place, and for all that follows the walk.
fn walk_has_room() -> bool {
    return has_room();
}

// Some loop of the walk, or before it, is done by all that took it together.
fn walk_turn() {
    rejoin();
}

// From the beginning, as for another segment.
fn walk_anew() {
    walk_stopped = false;
}

fn walk_stop(place: u32, done: bool) {
    walk_stopped = !done;
}

fn walk_suspended() -> bool {
    return walk_stopped;
}
