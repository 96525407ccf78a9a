// No lights.

fn lit_radiance(material: Material, color: vec3f, x: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    return vec3f(0.0);
}
