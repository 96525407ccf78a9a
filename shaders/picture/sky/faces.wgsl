// Six pictures at infinity, a "sky box" (W04 §4.3): +x, -x, +y, -y, +z, -z, each upright as seen from inside (the top edge
// of -z borders on +y).

struct Sky {
    // The first four faces' pictures, then the last two.
    faces: vec4u,
    more_faces: vec2u,
    intensity: f32,
}

@group(0) @binding(163) var<uniform> sky: Sky;

fn sky_radiance(d: vec3f) -> vec3f {
    let size = abs(d);
    let along_x = size.x >= max(size.y, size.z);
    let along_y = !along_x && size.y >= size.z;
    // Towards -z or +z by default: right is ±x there.
    var face = select(sky.more_faces.y, sky.more_faces.x, d.z > 0.0);
    var p = vec3f(-sign(d.z) * d.x, d.y, size.z);
    if along_x {
        face = select(sky.faces.y, sky.faces.x, d.x > 0.0);
        p = vec3f(sign(d.x) * d.z, d.y, size.x);
    }
    if along_y {
        face = select(sky.faces.w, sky.faces.z, d.y > 0.0);
        p = vec3f(d.x, sign(d.y) * d.z, size.y);
    }
    return sky.intensity * image_sample(face, 0.5 + 0.5 * vec2f(p.x, -p.y) / p.z, false);
}
