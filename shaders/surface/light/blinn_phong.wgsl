// The Blinn–Phong answer to light from one direction.

// to_light, normal and view (towards the viewer) are unit vectors.
fn blinn_phong(material: Material, color: vec3f, to_light: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    let facing = max(dot(normal, to_light), 0.0);
    let halfway = normalize(to_light + view);
    let highlight = pow(max(dot(normal, halfway), 1e-6), material.shininess);
    return facing * color + select(0.0, highlight, facing > 0.0) * material.specular;
}
