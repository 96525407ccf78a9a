// A material that radiates its color.

const EMISSIVE: u32 = 0u;

fn radiance_emissive(material: Material, color: vec3f, lit: Lit) -> vec3f {
    return color;
}

fn bsdf_emissive(material: Material, color: vec3f) -> Bsdf {
    return Bsdf(color, material.diffuse, vec3f(0.0), 1.0);
}
