// Computes the bundle of light of a pixel from the ends of the rays through its corners.

fn pixel_bundle(pixel: vec2u) -> Bundle {
    let none = Bundle(vec3f(0.0), vec3f(0.0), 0u);
    if !corners_shared(frame.origin + pixel) {
        return none;
    }
    let a = pixel_corner[place_in_tile(pixel)];
    let b = pixel_corner[place_in_tile(pixel + vec2u(1u, 0u))];
    let c = pixel_corner[place_in_tile(pixel + vec2u(0u, 1u))];
    let d = pixel_corner[place_in_tile(pixel + vec2u(1u, 1u))];
    if any(vec3u(b.end, c.end, d.end) != vec3u(a.end)) {
        return none;
    }
    let across = 0.5 * (apart(a, b) + apart(c, d));
    let down = 0.5 * (apart(a, c) + apart(b, d));
    if max(dot(across, across), dot(down, down)) < WIDEST_BUNDLE * WIDEST_BUNDLE {
        return Bundle(across, down, a.end);
    }
    return none;
}
