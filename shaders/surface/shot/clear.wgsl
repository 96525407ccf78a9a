// A path that shooting has found, followed once more as any ray is, against what is opaque, from the light to the place.

// How near the path comes to the place, in parts of the distance between both. Nearer to it nothing is asked.
const REACH: Real = 1e-3;

fn shot_clear(source: Real3, d: Real3, place: Real3) -> bool {
    rejoin();
    let reach = REACH * distance(source, place);
    var ray = shot_start(source, d);
    clear_last_hit();
    var there = false;
    var clear = true;
    for (var k = 0u; k < schedule.max_segments && clear && !there; k++) {
        if !has_room() {
            unfinished = true;
            break;
        }
        var next = ray;
        let s = follow_segment(&next);
        let t = nearest_fraction(s, place);
        there = distance(segment_point(s, t), place) < reach;
        let pieces = segment_pieces(s);
        let near = items_near(s);
        var hit = listed_hit(s, pieces, near);
        walk_anew();
        hit = structure_hit(s, select(0u, pieces, (near & NEAR_STRUCTURE) != 0u), hit);
        unfinished = unfinished || walk_suspended();
        let before = hit.primitive != NOTHING && (!there || hit.t < t);
        clear = !(before && distance(segment_point(s, hit.t), place) > reach);
        clear = clear && (there || open_status(s, next.tau, 0u) == ALIVE);
        ray = next;
    }
    walk_anew();
    return clear && there;
}
