// As surface/shadow/straight.wgsl, in colour: light that asks for it is weakened by the clear things on its way, which it goes straight on
// through, and by what media take from it.

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
        if FILTERS {
            if shadows == WEAKENED {
                share *= filtered_share(at, part);
            }
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

// What has an interior lets light through: as much as is transmitted by Fresnel's law, of light that asks for that.
fn crossing_share(shadows: u32, hit: ptr<function, Hit>, x: Real3, way: Real3) -> f32 {
    if !SPLITS {
        return 0.0;
    }
    let surface = met_surface(hit, x);
    let own = materials[surface.material];
    if shadows == SHUT_OUT || !is_clear(own.kind) {
        return 0.0;
    }
    let near_medium = medium_object();
    let n1 = medium_index(x);
    enter_set(set_beyond(1u << own.bit, surface, x));
    if shadows != WEAKENED || medium_object() == near_medium {
        return 1.0;
    }
    let n2 = medium_index(x);
    // A line that is not bent meets the surface at one angle from both sides. It is taken for that in the thinner medium, or light would
    // be reflected totally where it has come in through the same glass.
    let thin = min(n1, n2);
    return f32(1.0 - refraction(thin * normalize(way), surface.across, thin, max(n1, n2)).reflectance);
}
