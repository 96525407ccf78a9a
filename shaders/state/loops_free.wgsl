// The device runs as many loop iterations as it takes.

// Is there room for one more segment in this pass?
fn has_room() -> bool {
    return true;
}

// May loops of this pass have been cut short? Then what they came to is not to be used.
fn is_spent() -> bool {
    return false;
}

// At the end of what some have done side by side: who goes on without the others knows what they have counted.
fn rejoin() {
}
