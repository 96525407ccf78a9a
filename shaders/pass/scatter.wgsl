// Rays that met a surface they go on from: refracted or reflected there, each is under way again. Those that are under way anyway
// move along to the slot that the next pass reads, where this one leaves the others.

@compute @workgroup_size(8, 8)
fn scatter(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let spot = living_pixel(group, groups, lane);
    let pixel = spot.pixel;
    let word = load_status(pixel);
    let code = select(ESCAPED, status_code(word), spot.valid);
    load_region(pixel);
    let ray = load_ray(pixel, word);
    if code == HIT {
        let hit = load_hit(pixel);
        let end = path_end(ray, hit);
        let surface = hit_surface(hit.primitive, end.x);
        let scattered = scattered_at(materials[surface.material], surface, end, ray.index, pixel);
        if scattered.goes_on {
            let phase = law_start(end.x, scattered.v);
            var next = ray;
            next.phase = phase;
            next.tau = end.tau;
            next.memory = first_memory(phase);
            next.index += 1u;
            let left = scale_weight(pixel, scattered.weight);
            if scattered.cut || left < DARK {
                store_status(pixel, status_word(word, CUT, status_slot(word), ray.index));
            } else if next.index >= schedule.max_segments || status_surfaces(word) >= schedule.max_surfaces {
                store_status(pixel, status_word(word, EXHAUSTED, status_slot(word), ray.index));
            } else {
                store_ray(pixel, next);
                store_region(pixel);
                store_hit(pixel, Hit(Real(next.index), hit.primitive));
                store_status(pixel, status_word(word + ONE_SURFACE, ALIVE, turn.end, next.index));
            }
        }
    }
    if code == ALIVE && turn.again == 1u {
        store_ray(pixel, ray);
        store_status(pixel, status_word(word, ALIVE, turn.end, ray.index));
    }
}
