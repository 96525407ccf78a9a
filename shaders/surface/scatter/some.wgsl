// Scatters rays at surfaces that reflect or transmit; such rays become active again.

fn may_scatter(code: u32) -> bool {
    return code == HIT;
}

// ray: at the start of the segment that met the surface. It is returned active from there, or with the status that ends it; HIT if the
// surface is opaque, which is then stored in `met`.
fn scatter_ray(ray: Ray, met: ptr<function, Hit>, pixel: vec2u) -> Ray {
    let end = path_end(ray, *met);
    let surface = met_surface(met, end.x);
    // A ray that ends here stays on the side that it came from.
    let side = region_bits();
    if COUNTS_TRANSFER {
        note_glow();
    }
    let scattered = scattered_at(materials[surface.material], surface, end, ray.index, pixel);
    var next = ray;
    if !scattered.continues {
        return next;
    }
    if TRANSFERS {
        transfer_left(pixel, ray, end, side);
    }
    if FINDS_CAUSTICS {
        note_sent();
    }
    if scale_throughput(scattered.throughput) || scattered.cut {
        next.status = CUT;
        enter_set(side);
        return next;
    }
    if ray.index + 1u >= schedule.max_segments {
        next.status = EXHAUSTED;
        enter_set(side);
        return next;
    }
    if KEEPS_LENGTH {
        add_length(pixel, ray.phase, end.x, end.v);
    }
    var x = end.x;
    if HAS_THROAT {
        pass_throat(materials[surface.material].kind, &x);
    }
    next.phase = opaque_phase(law_start(x, scattered.v));
    next.tau = opaque(end.tau);
    next.rest = 0.0;
    next.memory = first_memory(next.phase);
    next.index += 1u;
    next.status = ALIVE;
    set_last_hit((*met).primitive);
    return next;
}
