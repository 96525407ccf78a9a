// Radiates its colour.

const EMISSIVE: u32 = 0u;

fn radiance_emissive(material: Material, color: vec3f, lit: Lit) -> vec3f {
    return color;
}

// What it gives back of other light lies where other kinds have their highlight.
fn answer_emissive(material: Material, color: vec3f) -> Answer {
    return Answer(color, material.specular, vec3f(0.0), 1.0);
}
