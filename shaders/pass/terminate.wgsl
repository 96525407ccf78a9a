// Which rays ended with this segment (W04 §4.1). An ended ray stays at the segment's start; the others go on from its end.

@compute @workgroup_size(GROUP)
fn terminate(own: Invocation) {
    let spot = living_ray(own);
    var fate = segment_fate(load_segment(spot.pixel), load_tau(spot.pixel), spot.index, load_hit(spot.pixel));
    fate = select(fate, UNFINISHED, walk_unfinished(spot.pixel));
    let lives = spot.alive && fate == ALIVE;
    if spot.alive {
        let next = status_word(ALIVE, turn.end, spot.index + 1u);
        store_status(spot.pixel, select(status_word(fate, turn.start, spot.index), next, lives));
        tally_segments(1u);
    }
    keep_living(lives || (spot.alive && may_go_on(fate)), spot.pixel, own.lane);
    total_segments(own.lane);
}
