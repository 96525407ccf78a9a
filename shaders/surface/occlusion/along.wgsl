// Ambient occlusion along the scene's own law, which may bend what a place sees of its surroundings: one path a sample, in a direction that
// is drawn like matte light's, as fast as the ray that the place is seen by. If it is captured or meets anything no light comes along it.

// How a ray came to the place that is seen.
var<private> arrival: PathPoint;

fn note_arrival(end: PathPoint) {
    arrival = end;
}

fn open_share(lit: Lit, way: vec3f) -> Share {
    let before = region_bits();
    let phase = opaque_phase(law_start(lit.start, length(arrival.v) * Real3(way)));
    var ray = Ray(phase, arrival.tau, 0.0, first_memory(phase), 0.0, 0u, 0u, 0u, ALIVE);
    clear_last_hit();
    var passed: Real = 0.0;
    var met = false;
    for (var k = 0u; k < schedule.max_segments && passed < ambient.distance && !met && ray.status == ALIVE; k++) {
        if !has_room() {
            unfinished = true;
            break;
        }
        // It begins where it does; its later segments lie behind one another.
        mark_line(k == 0u);
        var next = ray;
        let s = follow_segment(&next);
        let hit = first_met(s, segment_pieces(s));
        let part = segment_length(s);
        met = hit.primitive != NOTHING && passed + hit.t * part < ambient.distance;
        next.status = open_status(s, next.tau, k);
        passed += part;
        ray = next;
    }
    walk_anew();
    mark_line(false);
    enter_set(before);
    // What ends it farther away shuts nothing out.
    let ended = ray.status != ALIVE && ray.status != ESCAPED && ray.status != ENDED && passed < ambient.distance;
    unfinished = unfinished || (ended && !met && ray.status != CAPTURED);
    return select(Share(1.0), Share(0.0), met || ended);
}

// About: between the lengths of its chord and of its Bézier polygon.
fn segment_length(s: Segment) -> Real {
    let chord = distance(s.x0, s.x1);
    let b1 = s.x0 + (s.h / 3.0) * s.v0;
    let b2 = s.x1 - (s.h / 3.0) * s.v1;
    return 0.5 * (chord + distance(s.x0, b1) + distance(b1, b2) + distance(b2, s.x1));
}
