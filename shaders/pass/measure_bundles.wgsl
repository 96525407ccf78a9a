// Measures the bundles of light of all pixels, after each round of the grid.

@compute @workgroup_size(GROUP)
fn measure_bundles(own: Invocation) {
    let spot = grid_pixel(own);
    if KEEPS_BUNDLES {
        // Also around the tile, for the corners of its pixels.
        if spot.valid && inside_grid(spot.pixel) && frame.branch == 0u {
            pixel_bundles[place_in_tile(spot.pixel)] = bundle_of(measured_bundle(spot.pixel));
        }
    }
    if spot.valid && inside_margin(spot.pixel) {
        let measured = measured_bundle(spot.pixel);
        if DESCRIBES_BUNDLES {
            if frame.branch == 0u {
                keep_bundle_layers(spot.pixel, measured);
            }
        }
        if DEFERS_SKY {
            if !is_apart(spot.pixel) {
                add_sky(spot.pixel, measured);
            }
        }
    }
}
