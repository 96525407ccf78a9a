// A material that radiates like a black body.

const BLACKBODY: u32 = 9u;

fn radiance_blackbody(material: Material, color: vec3f, lit: Lit) -> vec3f {
    return color * material.brightness * black_body_color(material.temperature * color_shift(), material.temperature);
}

fn bsdf_blackbody(material: Material, color: vec3f) -> Bsdf {
    return Bsdf(color * material.brightness * black_body_color(material.temperature, material.temperature), vec3f(0.0), vec3f(0.0), 1.0);
}
