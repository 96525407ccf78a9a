// Paths are lines as those to lights are.

fn mark_line(begins: bool) {
}
