// Every pixel in every pass, ended or not: the 2004 paper without its early termination (masks off).

fn active_pixel(own: Invocation) -> Place {
    return grid_pixel(own);
}

fn ray_wanted(code: u32) -> bool {
    return true;
}

fn keep_active(alive: bool, pixel: vec2u, lane: u32) {
    workgroupBarrier();
}
