// A cube of six images at infinity, a "sky box" (W04 §4.3): +x, -x, +y, -y, +z, -z, each upright as seen from inside (the top edge of -z
// borders on +y).

struct Sky {
    // The images of the first four faces, then those of the last two.
    faces: vec4u,
    more_faces: vec2u,
    intensity: f32,
    // The axes of the map in the scene.
    first: vec3f,
    second: vec3f,
    third: vec3f,
}

var<uniform> sky: Sky;

// Returns a direction of the scene in the axes of the map.
fn in_sky_axes(d: vec3f) -> vec3f {
    return vec3f(dot(sky.first, d), dot(sky.second, d), dot(sky.third, d));
}

// The face that a direction points to, and a vector in the axes of that face: right, up and ahead.
struct SkyFace {
    face: u32,
    turned: vec3f,
}

fn sky_face(d: vec3f, a: vec3f) -> SkyFace {
    let size = abs(d);
    let side = sign(d);
    if size.x >= max(size.y, size.z) {
        return SkyFace(select(sky.faces.y, sky.faces.x, d.x > 0.0), vec3f(side.x * a.z, a.y, side.x * a.x));
    }
    if size.y >= size.z {
        return SkyFace(select(sky.faces.w, sky.faces.z, d.y > 0.0), vec3f(a.x, side.y * a.z, side.y * a.y));
    }
    return SkyFace(select(sky.more_faces.y, sky.more_faces.x, d.z > 0.0), vec3f(-side.z * a.x, a.y, side.z * a.z));
}

// Returns the displacement in the image of the face for a small step from a direction.
fn sky_span(d: vec3f, step: vec3f) -> vec2f {
    let p = sky_face(d, d).turned;
    let q = sky_face(d, step).turned;
    return 0.5 * vec2f(q.x - p.x / p.z * q.z, -q.y + p.y / p.z * q.z) / p.z;
}

fn sky_radiance(way: vec3f) -> vec3f {
    let d = in_sky_axes(way);
    let ahead = sky_face(d, d);
    let p = ahead.turned;
    if FILTERS_IMAGES {
        note_spans(sky_span(d, in_sky_axes(footprint[0])), sky_span(d, in_sky_axes(footprint[1])));
    }
    return sky.intensity * image_sample(ahead.face, 0.5 + 0.5 * vec2f(p.x, -p.y) / p.z, false);
}
