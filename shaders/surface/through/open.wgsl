// Whoever goes through a surface is on its other side, and no more.

fn pass_through(object: u32) {
}
