// There are no surfaces.

fn seen_at(ray: Ray, pixel: vec2u) -> Seen {
    return Seen(path_end(ray, Hit(0.0, NOTHING)), vec3f(0.0), vec3f(0.0), 0u);
}

fn clear_hit(pixel: vec2u) {
}

fn store_hit(pixel: vec2u, hit: Hit) {
}

fn load_hit(pixel: vec2u) -> Hit {
    return Hit(0.0, NOTHING);
}
