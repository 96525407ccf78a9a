// No lights.

fn lit_radiance(material: Material, color: vec3f, lit: Lit) -> vec3f {
    return vec3f(0.0);
}
