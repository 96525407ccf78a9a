// Which rays ended with this segment (W04 §4.1). An ended ray stays at the segment's start; the others go on from its end.

@compute @workgroup_size(GROUP)
fn terminate(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let spot = living_pixel(group, groups, lane);
    let word = load_status(spot.pixel);
    let alive = spot.valid && status_code(word) == ALIVE;
    let index = status_index(word);
    load_region(spot.pixel);
    var fate = segment_fate(load_segment(spot.pixel), load_tau(spot.pixel), index, load_hit(spot.pixel));
    fate = select(fate, UNFINISHED, walk_unfinished(spot.pixel));
    let lives = alive && fate == ALIVE;
    if alive {
        let next = status_word(ALIVE, turn.end, index + 1u);
        store_status(spot.pixel, select(status_word(fate, turn.start, index), next, lives));
        tally_segments(1u);
    }
    keep_living(lives || (alive && may_go_on(fate)), spot.pixel, lane);
    total_segments(lane);
}
