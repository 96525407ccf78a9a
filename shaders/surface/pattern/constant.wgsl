// The same colour everywhere.

const CONSTANT: u32 = 0u;

fn pattern_constant(material: Material, uv: vec2f) -> vec3f {
    return material.color;
}
