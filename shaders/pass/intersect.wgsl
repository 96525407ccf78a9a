// Intersects every segment with the scene (W04 §3.3). The pass runs again if a walk may be suspended, and then skips complete walks.

@compute @workgroup_size(GROUP)
fn intersect(own: Invocation) {
    let spot = active_ray(own);
    load_last_hit(spot.pixel, spot.index);
    if spot.valid && ray_wanted(spot.code) && walk_needed(spot.pixel) {
        if TRAVELS {
            note_segment(load_start_tau(spot.pixel));
        }
        let segment = load_segment(spot.pixel);
        let hit = first_hit(segment, nearby(segment), spot.pixel);
        if spot.code == ALIVE && !walk_suspended() {
            store_hit(spot.pixel, hit);
            // A result of loops that were cut short is not final.
            if is_spent() {
                store_status(spot.pixel, status_word(known_status(ALIVE), dispatch.start, spot.index));
            }
        }
    }
}
