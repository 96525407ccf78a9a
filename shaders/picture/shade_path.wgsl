// What a path has found goes into the picture, once it is over: the light of surfaces on its way, and of the sky at its end.

// ray: at the start of its last segment, which ended on `end`.
fn shade_ray(pixel: vec2u, ray: Ray, end: Hit) {
    let seen = seen_at(ray, end);
    if carried.flight != OVER && (ray.status == ESCAPED || ray.status == MISSED) {
        filter_last(ray, seen.end);
        gather(sky_radiance(vec3f(normalize(seen.end.v))), seen.end.x);
    }
    var found = carried.gathered;
    clamp_sample(pixel, &found);
    keep_spread(pixel, found);
    add_color(pixel, found);
    add_coverage(pixel, ray.status);
    see_through(pixel, ray.status, seen.end.x);
    if carried.recorded == 0u {
        keep_layers(pixel, ray, seen);
    }
    // Corners that look alike prove nothing of a path's light: no two are said to be of the same object.
    keep_corner(pixel, ray, Seen(seen.end, seen.color, seen.normal, place_of_path(pixel)));
}
