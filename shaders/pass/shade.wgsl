// Deferred local illumination (W04 §3.4, §7): once per ray, after all segments. What could not be followed stays black, and is
// counted and shown in the status output, never painted as sky.

@compute @workgroup_size(GROUP)
fn shade(own: Invocation) {
    let spot = round_pixel(own);
    let pixel = spot.pixel;
    let followed = spot.valid && status_code(load_status(pixel)) != RESTING;
    if followed {
        load_region(pixel);
        load_weight(pixel);
        let ray = load_ended(pixel);
        let seen = seen_at(ray, pixel);
        let code = ray.status;
        var color = seen.color;
        if code == ESCAPED || code == MISSED {
            color = sky_radiance(vec3f(normalize(seen.end.v)));
        }
        add_color(pixel, color * end_weight(seen.end.x));
        add_coverage(pixel, code);
        keep_layers(pixel, ray, seen);
        keep_corner(pixel, ray, seen);
        tally_status(code);
    }
    end_round(followed, pixel, own.lane);
    total_statuses(own.lane);
}
