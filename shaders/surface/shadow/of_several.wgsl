// Some lights cast shadows, of several kinds.

fn casts(shadows: u32) -> bool {
    return shadows != 0u;
}
