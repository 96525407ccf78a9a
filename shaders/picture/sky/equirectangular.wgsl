// An equirectangular environment map at infinity, seen from inside: -z at its center, +x to the right of that, +y at the top.

struct Sky {
    intensity: f32,
    // The axes of the map in the scene.
    first: vec3f,
    second: vec3f,
    third: vec3f,
    image: u32,
}

var<uniform> sky: Sky;

// Returns a direction of the scene in the axes of the map.
fn in_sky_axes(d: vec3f) -> vec3f {
    return vec3f(dot(sky.first, d), dot(sky.second, d), dot(sky.third, d));
}

// Returns the displacement in the map for a small step from a direction.
fn sky_span(d: vec3f, step: vec3f) -> vec2f {
    let across = dot(d.xz, d.xz);
    let u = (d.x * step.z - d.z * step.x) / across;
    let v = d.y * dot(d.xz, step.xz) / sqrt(across) - sqrt(across) * step.y;
    return vec2f(u / (2.0 * PI), v / PI);
}

fn sky_radiance(way: vec3f) -> vec3f {
    let d = in_sky_axes(way);
    let size = vec2f(image_size(sky.image));
    let u = 0.5 + f32(arc_tangent(Real(d.x), Real(-d.z))) / (2.0 * PI);
    let v = 0.5 - f32(arc_tangent(Real(d.y), Real(length(d.xz)))) / PI;
    if FILTERS_IMAGES {
        note_spans(sky_span(d, in_sky_axes(footprint[0])), sky_span(d, in_sky_axes(footprint[1])));
    }
    // The map wraps around the axis of the poles, not over the poles.
    return sky.intensity * image_sample(sky.image, vec2f(u, clamp(v, 0.5 / size.y, 1.0 - 0.5 / size.y)), true);
}
