// Computes shadows by straight lines (G95 §6: light is massless until it hits something), for lights that ask for them. Transparent objects
// cast none.

alias Share = f32;

fn casts(shadows: u32) -> bool {
    if ALL_CAST {
        return true;
    }
    return shadows != 0u;
}

// Returns 1, or 0 if something opaque is between `start` and the light, which is at the end of `way`.
fn light_share(shadows: u32, faces: bool, start: Real3, way: Real3) -> Share {
    if !FOLLOWS_LINES {
        return 1.0;
    }
    if SHUTS_OUT {
        note_light(shadows);
    }
    if !casts(shadows) || !faces {
        return 1.0;
    }
    let before = region_bits();
    mark_line(true);
    clear_last_hit();
    var at = start;
    var share = 1.0;
    for (var k = 0u; k < CROSSINGS && walk_has_room(); k++) {
        let rest = start + way - at;
        let s = Segment(at, rest, at + rest, rest, 1.0);
        let hit = first_met(s, 1u);
        if hit.primitive == NOTHING {
            break;
        }
        at += hit.t * rest;
        if !passes_light(hit_surface(hit.primitive, at).material) {
            share = 0.0;
            break;
        }
    }
    unfinished = unfinished || !walk_has_room();
    walk_anew();
    mark_line(false);
    enter_set(before);
    return share;
}
