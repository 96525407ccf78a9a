// Radiates its colour.

const EMISSIVE: u32 = 0u;

fn radiance_emissive(material: Material, color: vec3f, lit: Lit) -> vec3f {
    return color;
}
