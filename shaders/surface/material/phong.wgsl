// Ambient, diffuse and Blinn–Phong specular light from straight connections to the lights (W04 §3.4, "fake" illumination).

const PHONG: u32 = 1u;

fn radiance_phong(material: Material, color: vec3f, lit: Lit) -> vec3f {
    if IS_OCCLUDED {
        return material.emission + open_part(lit) * material.ambient * color + lit_radiance(material, color, lit);
    }
    return material.emission + material.ambient * color + lit_radiance(material, color, lit);
}

// In path tracing the highlight is a glossy lobe, and there is no ambient light.
fn bsdf_phong(material: Material, color: vec3f) -> Bsdf {
    return Bsdf(material.emission, color, material.specular, material.exponent);
}

// Returns the Blinn–Phong reflection of light from one direction: to_light, normal and view (towards the viewer) are unit vectors.
fn blinn_phong(material: Material, color: vec3f, to_light: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    let facing = max(dot(normal, to_light), 0.0);
    let halfway = normalize(to_light + view);
    let highlight = pow(max(dot(normal, halfway), 1e-6), material.exponent);
    return facing * color + select(0.0, highlight, facing > 0.0) * material.specular;
}
