// Gathers the light of stars in every pixel, from the cells around it.

@compute @workgroup_size(GROUP)
fn gather_stars(own: Invocation) {
    let spot = grid_pixel(own);
    if spot.valid && inside_margin(spot.pixel) {
        let place = place_in_tile(spot.pixel);
        if SAMPLE_IS_GRID {
            pixel_color[place] += starlight(spot.pixel);
        } else {
            pixel_starlight[place] = starlight(spot.pixel) + select(pixel_starlight[place], vec3f(0.0), frame.branch == 0u);
        }
    }
}
