// Lists the cells of the grid of rays that have starlight, after each round of the grid.

@compute @workgroup_size(GROUP)
fn find_stars(own: Invocation) {
    let spot = grid_pixel(own);
    if spot.valid {
        let place = place_in_tile(spot.pixel);
        if place == 0u {
            atomicStore(&star_counts.listed, 0u);
        }
        star_heads[place] = 0u;
        if is_lit(spot.pixel) {
            list_cell(spot.pixel);
        }
    }
}
