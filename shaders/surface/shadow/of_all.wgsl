// Every light casts shadows.

fn casts(shadows: u32) -> bool {
    return true;
}
