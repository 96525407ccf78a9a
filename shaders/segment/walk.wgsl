// A segment's walk over the scene. Where it may need more loop iterations than one pass has, it stops where the room runs out. A later pass,
// which takes the same segment again, goes on from there: what is kept is the place in the structure that is next (the walk's order is
// fixed), and the nearest hit so far. Where no later pass does, the ray stays alive, and the host follows it by other passes.

// A place, counted from 1; 0 is a walk that has not begun.
var<storage, read_write> pixel_walk: array<u32>;

// The place to go on from, counted from 1; 0 when the walk is complete.
var<private> walk_place: u32;

fn walk_begin() -> u32 {
    if !RESUMES {
        return 0u;
    }
    return max(walk_place, 1u) - 1u;
}

// There is room for the next place, and for all that follows the walk.
fn walk_has_room() -> bool {
    if !SUSPENDS {
        return true;
    }
    return has_room();
}

// There is room for `count` items in one place.
fn walk_has_room_for(count: u32) -> bool {
    if !SUSPENDS {
        return true;
    }
    return has_room_for(count);
}

// Some loop of the walk, or before it, is done by all that took it together.
fn walk_turn() {
    if SUSPENDS {
        rejoin();
    }
}

// From the beginning, as for another segment.
fn walk_anew() {
    if SUSPENDS {
        walk_place = 0u;
    }
}

fn walk_stop(place: u32, done: bool) {
    if SUSPENDS {
        walk_place = select(place + 1u, 0u, done);
    }
}

fn walk_suspended() -> bool {
    if !SUSPENDS {
        return false;
    }
    return walk_place != 0u;
}

fn walked_hit(s: Segment, near: u32, pixel: vec2u) -> Hit {
    let pieces = segment_pieces(s);
    let sought = select(0u, pieces, (near & NEAR_STRUCTURE) != 0u);
    var hit: Hit;
    if RESUMES {
        let kept = pixel_walk[place_in_tile(pixel)];
        hit = load_hit(pixel);
        if kept == 0u {
            hit = listed_hit(s, pieces, near);
        }
        walk_place = kept;
        hit = structure_hit(s, sought, hit);
        if is_spent() {
            // What loops that were cut short came to is no place to go on from.
            walk_anew();
        }
        if walk_place != kept {
            pixel_walk[place_in_tile(pixel)] = walk_place;
        }
        if walk_suspended() {
            store_hit(pixel, hit);
        }
    } else {
        hit = listed_hit(s, pieces, near);
        if HAS_STRUCTURE {
            hit = structure_hit(s, sought, hit);
        }
    }
    return Hit(select(hit.t, 0.0, hit.primitive == NOTHING), hit.primitive);
}

// In the first of a segment's walks always, in the later ones only if it was suspended.
fn walk_needed(pixel: vec2u) -> bool {
    if !RESUMES {
        return true;
    }
    return dispatch.again == 0u || pixel_walk[place_in_tile(pixel)] != 0u;
}

// After all of a segment's walks.
fn walk_unfinished(pixel: vec2u) -> bool {
    if !RESUMES {
        return false;
    }
    return pixel_walk[place_in_tile(pixel)] != 0u;
}
