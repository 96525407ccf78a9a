// Shades an image from the stored ends of its paths.

@compute @workgroup_size(GROUP)
fn reshade(own: Invocation) {
    let spot = grid_pixel(own);
    let pixel = spot.pixel;
    if spot.valid {
        stored_end = load_end(pixel);
        if stored_end.status != ALIVE {
            enter_set(stored_end.inside);
            restore_throughput(stored_end.throughput);
            if ENUMERATES {
                branch_code = stored_end.branch;
                store_branches(pixel);
            }
            var ray: Ray;
            ray.status = stored_end.status;
            ray.tau = stored_end.tau;
            shade_ray(pixel, ray, Hit(0.0, stored_end.primitive));
            tally_status(lit_status(ray.status, EXHAUSTED));
        }
    }
    workgroupBarrier();
    total_statuses(own.lane);
}
