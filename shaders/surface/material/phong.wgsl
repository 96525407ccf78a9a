// Ambient, diffuse and Blinn–Phong specular light from straight connections to the lights (W04 §3.4, "fake" illumination).

const PHONG: u32 = 1u;

fn radiance_phong(material: Material, color: vec3f, lit: Lit) -> vec3f {
    if IS_OCCLUDED {
        return material.emission + open_part(lit) * material.ambient * color + lit_radiance(material, color, lit);
    }
    return material.emission + material.ambient * color + lit_radiance(material, color, lit);
}

// On a path the highlight is a glossy lobe, and there is no ambient light.
fn answer_phong(material: Material, color: vec3f) -> Answer {
    return Answer(material.emission, color, material.specular, material.shininess);
}
