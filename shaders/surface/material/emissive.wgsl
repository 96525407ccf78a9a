// Radiates its colour.

const EMISSIVE: u32 = 0u;

fn radiance_emissive(material: Material, color: vec3f, x: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    return color;
}
