// Adds the light that a ray saw, and the emission of media along its path, to the image. Rays that could not be followed stay black, and
// are counted and shown in the status output, never painted as sky.

// ray: at the start of its last segment, which ended on `end`.
fn shade_ray(pixel: vec2u, ray: Ray, end: Hit) {
    if FOLLOWS_PATHS {
        shade_path(pixel, ray, end);
        return;
    }
    if IS_OCCLUDED {
        note_pixel(pixel);
    }
    if KNOWS_SHIFT {
        note_frequency(pixel, ray);
    }
    if KEEPS_FOOTPRINTS {
        note_bundle(pixel);
    }
    let seen = seen_at(ray, end);
    if TRANSFERS {
        if !SHADES_ENDS {
            if COUNTS_TRANSFER {
                note_glow();
            }
            transfer_end(pixel, ray, seen.end);
        }
    }
    if KEEPS_ENDS {
        if !is_apart(pixel) {
            store_end(pixel, ray.status, end.primitive, seen.end);
        }
    }
    let code = ray.status;
    var light = seen.color;
    if code == ESCAPED || code == MISSED {
        if HAS_TWO_SKIES {
            note_side(seen.end.x);
        }
        if FOLLOWS_SHIFT {
            note_sky(ray, seen.end);
        }
        light = sky_seen(pixel, vec3f(normalize(seen.end.v)));
    }
    if HAS_GRID {
        note_grid(pixel, code, seen);
        if is_apart(pixel) {
            return;
        }
    }
    if SEES_GLOW {
        gather(light, seen.end.x);
        light = carried.gathered;
    } else {
        light *= end_throughput(seen.end.x);
    }
    if IS_SPECTRAL {
        end_transfer(pixel, light, seen.end.x);
        add_radiation(pixel);
        light = shown_radiation();
    }
    var color = light;
    if ADDS_STARLIGHT {
        // Once for each sample of the pixel; in an adaptive image, once to their mean.
        if !ADAPTS {
            color += select(vec3f(0.0), pixel_starlight[place_in_tile(pixel)], !is_grid(pixel) & (frame.branch == 0u));
        }
    }
    add_color(pixel, color);
    if KEEPS_ORDERS {
        add_order(pixel, light);
    }
    add_coverage(pixel, code);
    if SEES_THROUGH {
        see_through(pixel, code, seen.end.x);
    }
    keep_layers(pixel, ray, seen);
    if KEEPS_CROSSINGS {
        if code == HIT {
            add_crossing(pixel, hit_surface(end.primitive, seen.end.x), seen.end);
        }
    }
    if ADAPTS {
        keep_corner(pixel, ray, seen);
    }
}

// Returns the light of the sky in a direction, as the observer sees it; 0 on the grid if it is added later.
fn sky_seen(pixel: vec2u, d: vec3f) -> vec3f {
    if DEFERS_SKY {
        if is_grid(pixel) {
            return vec3f(0.0);
        }
    }
    if KEEPS_FOOTPRINTS {
        fit_footprint(sky_end(pixel));
    }
    let light = sky_radiance(d);
    if BEAMS {
        return beamed(light);
    }
    return light;
}

// Adds the light of a finished path.
fn shade_path(pixel: vec2u, ray: Ray, end: Hit) {
    let start = departed(MISSED, ray.phase[0].xyz, ray.phase[1].xyz);
    if ray.status == MISSED {
        gather(sky_radiance(vec3f(normalize(start[1]))), start[0]);
    }
    var seen = Seen(PathPoint(start[0], start[1], ray.tau, 0.0), vec3f(0.0), vec3f(0.0), 0u);
    if SEES_PATH_ENDS {
        seen = seen_at(ray, end);
    }
    var found = carried.gathered;
    if CLAMPS {
        clamp_sample(pixel, &found);
    }
    if !ADAPTS {
        keep_spread(pixel, found);
    }
    add_color(pixel, found);
    add_coverage(pixel, ray.status);
    if SEES_THROUGH {
        see_through(pixel, ray.status, seen.end.x);
    }
    if carried.recorded == 0u {
        keep_layers(pixel, ray, seen);
    }
    if ADAPTS {
        // Similar colors of corners prove nothing about a path's light, so that no two corners count as the same object.
        keep_corner(pixel, ray, Seen(seen.end, seen.color, seen.normal, place_in_tile(pixel)));
    }
}
