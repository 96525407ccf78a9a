// Deferred local illumination (W04 §3.4, §7): once per ray, after all segments. What could not be followed stays black, and is
// counted and shown in the status output, never painted as sky.

@group(0) @binding(110) var red: texture_storage_2d<r32float, read_write>;
@group(0) @binding(111) var green: texture_storage_2d<r32float, read_write>;
@group(0) @binding(112) var blue: texture_storage_2d<r32float, read_write>;

// The samples' sum: the host divides once, at the end.
fn add_color(pixel: vec2u, c: vec3f) {
    let first = frame.sample + frame.branch == 0u;
    textureStore(red, pixel, vec4f(c.x + select(textureLoad(red, pixel).x, 0.0, first)));
    textureStore(green, pixel, vec4f(c.y + select(textureLoad(green, pixel).x, 0.0, first)));
    textureStore(blue, pixel, vec4f(c.z + select(textureLoad(blue, pixel).x, 0.0, first)));
}

@compute @workgroup_size(8, 8)
fn shade(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let spot = round_pixel(group, groups, lane);
    let pixel = spot.pixel;
    var code = ALIVE;
    let followed = spot.valid && status_code(load_status(pixel)) != RESTING;
    if followed {
        load_region(pixel);
        load_weight(pixel);
        let ray = load_ended(pixel);
        let seen = seen_at(ray, pixel);
        code = ray.status;
        var color = seen.color;
        if code == ESCAPED || code == MISSED {
            color = sky_radiance(vec3f(normalize(seen.end.v)));
        }
        add_color(pixel, color * end_weight(seen.end.x));
        add_coverage(pixel, code);
        keep_layers(pixel, ray, seen);
    }
    tally_fate(followed, code, lane);
    end_round(followed, pixel, lane);
}
