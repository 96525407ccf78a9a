// Gathers the light of stars in every pixel, from the cells around it.

@compute @workgroup_size(GROUP)
fn gather_stars(own: Invocation) {
    let spot = grid_pixel(own);
    if spot.valid && inside_margin(spot.pixel) {
        let place = place_in_tile(spot.pixel);
        let light = starlight(spot.pixel);
        if FIRST_IS_GRID {
            pixel_color[place] += select(light, vec3f(0.0), is_apart(spot.pixel));
        }
        if ADDS_STARLIGHT {
            pixel_starlight[place] = light + select(pixel_starlight[place], vec3f(0.0), frame.branch == 0u);
        }
    }
}
