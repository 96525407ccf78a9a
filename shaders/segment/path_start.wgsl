// Starts a path: the camera's ray (W04 §3.1), or a given ray, in the phase space of the law.

// Also sets the region and the throughput with which the ray starts. A pixel without a ray in this round rests.
fn path_start(pixel: vec2u) -> Ray {
    if DRAWS_WAVELENGTH {
        draw_wavelength(pixel);
    }
    if KEEPS_LENGTH {
        begin_length(pixel);
    }
    let given = picture_ray(sampled_pixel(pixel));
    let start = arrived(given);
    start_region(start.x, start.d, pixel);
    let phase = opaque_phase(law_start(start.x, start.d));
    start_throughput(phase[0].xyz);
    if TRANSFERS {
        start_transfer(pixel);
    }
    if KEEPS_CROSSINGS {
        begin_crossings(pixel, phase[0].xyz, length(given.x - start.x));
    }
    var ray = Ray(phase, 0.0, 0.0, first_memory(phase), 0.0, 0u, 0u, 0u, start.status);
    if ray.status == ALIVE && law_captured(phase[0].xyz, phase[1].xyz) {
        ray.status = CAPTURED;
    }
    if ENDS_BELOW {
        end_below(phase, &ray);
    }
    if ray.status != OUTSIDE && (!finite(phase[0].xyz) || !finite(phase[1].xyz)) {
        ray.status = FAILED;
    }
    if !(sample_wanted(pixel) && begin_branches(pixel)) {
        ray.status = RESTING;
    }
    return ray;
}
