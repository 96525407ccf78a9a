// Shadow rays as in surface/shadow/straight.wgsl, in color: with tinted shadows, light is attenuated by the transparent objects on its
// straight path, and by the matter on it.

alias Share = vec3f;

// Returns the transmittance from the light at the end of `way` to `start`; 0 if something opaque is between.
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
        if TRANSFERS {
            if shadows == WEAKENED {
                share *= line_share(at, part);
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

// Returns the transmittance of a surface with an interior: the Fresnel transmittance, for light with tinted shadows.
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
    // An undeviated line has one angle of incidence on both sides. It is taken as the angle in the thinner medium, because otherwise light
    // would be totally reflected where it has entered through the same glass.
    let thin = min(n1, n2);
    return f32(1.0 - refraction(thin * normalize(way), surface.normal, thin, max(n1, n2)).reflectance);
}
