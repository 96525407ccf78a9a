// As surface/shadow/straight.wgsl, in colour: light that asks for it is weakened by the clear things on its way, which it goes straight on
// through, and by what media take from it.

// Surfaces on one line: more of them shut it out.
const CROSSINGS: u32 = 64u;

alias Share = vec3f;

// What is left of the light at the end of `way` where it comes to `start`; 0 where something opaque lies between.
fn light_share(shadows: u32, faces: bool, start: Real3, way: Real3) -> Share {
    if shadows == 0u || !faces {
        return Share(1.0);
    }
    let before = region_bits();
    mark_line(true);
    clear_last_hit();
    var at = start;
    var share = Share(1.0);
    var there = false;
    for (var k = 0u; k < CROSSINGS && !there && has_room(); k++) {
        let rest = start + way - at;
        let s = Segment(at, rest, at + rest, rest, 1.0);
        var hit = first_met(s, 1u);
        there = hit.primitive == NOTHING;
        let part = select(hit.t, Real(1.0), there) * rest;
        if shadows == WEAKENED {
            share *= filtered_share(at, part);
        }
        at += part;
        if !there {
            share *= crossing_share(shadows, &hit, at, rest);
            there = all(share <= Share(0.0));
        }
    }
    unfinished = unfinished || !has_room();
    walk_anew();
    mark_line(false);
    enter_set(before);
    return select(Share(0.0), share, there);
}
