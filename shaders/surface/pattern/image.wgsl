// A picture, repeated.

const IMAGE: u32 = 2u;

fn pattern_image(material: Material, uv: vec2f) -> vec3f {
    if KEEPS_FOOTPRINTS {
        span_pattern(vec2f(1.0, -1.0) * material.repeat);
    }
    return image_sample(material.image, fract(vec2f(uv.x, 1.0 - uv.y) * material.repeat), true);
}
