// Computes the light of every listed cell.

@compute @workgroup_size(GROUP)
fn light_stars(own: Invocation) {
    let n = (own.group.y * STAR_ROW + own.group.x) * GROUP + own.lane;
    if n < star_work_in.count {
        light_listed_cell(n);
    }
}
