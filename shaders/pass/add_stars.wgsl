// Adds the light of stars to the sum over a pixel's samples, once for each sample.

@compute @workgroup_size(GROUP)
fn add_stars(own: Invocation) {
    let spot = grid_pixel(own);
    if spot.valid {
        let place = place_in_tile(spot.pixel);
        pixel_color[place] += pixel_starlight[place];
    }
}
