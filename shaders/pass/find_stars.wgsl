// Lists the cells of the grid of rays that have starlight, after each round of the grid.

@compute @workgroup_size(GROUP)
fn find_stars(own: Invocation) {
    let spot = grid_pixel(own);
    if spot.valid {
        star_slots[place_in_tile(spot.pixel)] = 0u;
        if is_lit(spot.pixel) {
            list_cell(spot.pixel);
        }
    }
}
