// A segment's walk over the scene is short enough for any pass.

fn walk_has_room() -> bool {
    return true;
}

// Some loop of the walk, or before it, is done by all that took it together.
fn walk_turn() {
}

// From the beginning, as for another segment.
fn walk_anew() {
}

fn walk_stop(place: u32, done: bool) {
}

fn walk_suspended() -> bool {
    return false;
}
