// The control rejects nothing.

fn tally_rejections(n: u32, lane: u32) {
}
