// What a ray saw goes into the picture. What could not be followed stays black, and is counted and shown in the status output, never
// painted as sky.

// ray: at the start of its last segment, which ended on `end`.
fn shade_ray(pixel: vec2u, ray: Ray, end: Hit) {
    note_pixel(pixel);
    note_frequency(pixel, ray);
    note_footprint(pixel, ray);
    let seen = seen_at(ray, end);
    filter_last(ray, seen.end);
    let code = ray.status;
    var color = seen.color;
    if code == ESCAPED || code == MISSED {
        note_side(seen.end.x);
        note_sky(ray, seen.end);
        color = sky_radiance(vec3f(normalize(seen.end.v)));
        beam_sky(&color);
    }
    let light = color * end_weight(seen.end.x);
    add_color(pixel, light);
    add_order(pixel, light);
    add_coverage(pixel, code);
    see_through(pixel, code, seen.end.x);
    keep_layers(pixel, ray, seen);
    keep_corner(pixel, ray, seen);
}
