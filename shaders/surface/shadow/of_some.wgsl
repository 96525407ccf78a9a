// Some lights cast shadows.

fn casts(shadows: u32) -> bool {
    return shadows == 1u;
}
