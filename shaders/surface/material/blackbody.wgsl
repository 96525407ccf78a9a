// Radiates as a black body does.

const BLACKBODY: u32 = 9u;

// In `emission`: its temperature in kelvins, and its luminance.
fn radiance_blackbody(material: Material, color: vec3f, lit: Lit) -> vec3f {
    let body = material.emission;
    return color * body.y * black_body_color(body.x * color_shift(), body.x);
}

fn answer_blackbody(material: Material, color: vec3f) -> Answer {
    let body = material.emission;
    return Answer(color * body.y * black_body_color(body.x, body.x), vec3f(0.0), vec3f(0.0), 1.0);
}
