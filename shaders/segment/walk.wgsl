// Suspends and resumes the walk of a segment through the scene. If it may need more loop iterations than one pass has, it stops before they
// run out. A later pass takes the same segment again and resumes: the next position in the structure is stored (the order of the walk is
// fixed), and the nearest hit so far. If no later pass does, the ray stays alive, and the host follows it by other passes.

// A position, counted from 1; 0 is a walk that has not begun.
var<storage, read_write> pixel_walk: array<u32>;

// The position to resume from, counted from 1; 0 when the walk is complete.
var<private> walk_place: u32;

fn walk_begin() -> u32 {
    if !RESUMES {
        return 0u;
    }
    return max(walk_place, 1u) - 1u;
}

// Returns `true` if there is room for the next position, and for everything after the walk.
fn walk_has_room() -> bool {
    if !SUSPENDS {
        return true;
    }
    return has_room();
}

// Returns `true` if there is room for `count` items in one position.
fn walk_has_room_for(count: u32) -> bool {
    if !SUSPENDS {
        return true;
    }
    return has_room_for(count);
}

// Synchronizes the counts after a loop of the walk, or before it, that all its lanes have finished.
fn walk_turn() {
    if SUSPENDS {
        rejoin();
    }
}

// Restarts the walk, for another segment.
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
            // The result of loops that were cut short is not a valid position to resume from.
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

// Returns `true` in the first walk of a segment; in later ones only if it was suspended.
fn walk_needed(pixel: vec2u) -> bool {
    if !RESUMES {
        return true;
    }
    return dispatch.again == 0u || pixel_walk[place_in_tile(pixel)] != 0u;
}

// Returns `true` if a walk of the segment is incomplete, after all of them.
fn walk_unfinished(pixel: vec2u) -> bool {
    if !RESUMES {
        return false;
    }
    return pixel_walk[place_in_tile(pixel)] != 0u;
}
