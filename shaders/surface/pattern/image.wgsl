// A picture, repeated.

const IMAGE: u32 = 2u;

fn pattern_image(material: Material, uv: vec2f) -> vec3f {
    return image_sample(material.image, fract(vec2f(uv.x, 1.0 - uv.y) * material.repeat), true);
}
