// Directional lights, at infinity.

struct DirectionalLight {
    // The unit vector along which the light travels.
    direction: vec3f,
    // 1 if it casts shadows.
    shadows: u32,
    color: vec3f,
}

var<storage, read> directional_lights: array<DirectionalLight>;

fn lit_by_directional(material: Material, color: vec3f, lit: Lit) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < arrayLength(&directional_lights); i++) {
        let to_light = -directional_lights[i].direction;
        let faces = dot(lit.normal, to_light) > 0.0;
        let share = light_share(directional_lights[i].shadows, faces, lit.start, way_out(lit.start, to_light));
        sum += share * directional_lights[i].color * blinn_phong(material, color, to_light, lit.normal, lit.view);
    }
    return sum;
}

// Returns the vector to the bounding sphere, beyond which there is nothing.
fn way_out(start: Real3, to_light: vec3f) -> Real3 {
    let d = Real3(to_light);
    let b = dot(start - bound.center, d);
    let c = dot(start - bound.center, start - bound.center) - bound.radius * bound.radius;
    return (sqrt(max(b * b - c, 0.0)) - b) * d;
}
