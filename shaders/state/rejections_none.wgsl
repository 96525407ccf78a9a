// The control rejects nothing.

fn tally_rejections(n: u32) {
}

fn total_rejections(lane: u32) {
}
