// What a ray saw, and what media have added to it on its way, goes into the picture.

// ray: at the start of its last segment, which ended on `end`.
fn shade_ray(pixel: vec2u, ray: Ray, end: Hit) {
    note_pixel(pixel);
    note_frequency(pixel, ray);
    note_footprint(pixel, ray);
    let seen = seen_at(ray, end);
    filter_last(ray, seen.end);
    let escaped = ray.status == ESCAPED || ray.status == MISSED;
    note_side(seen.end.x);
    note_sky(ray, seen.end);
    gather(select(seen.color, sky_radiance(vec3f(normalize(seen.end.v))), escaped), seen.end.x);
    add_color(pixel, carried.gathered);
    add_coverage(pixel, ray.status);
    see_through(pixel, ray.status, seen.end.x);
    keep_layers(pixel, ray, seen);
    keep_corner(pixel, ray, seen);
}
