// Lights far away.

struct DirectionalLight {
    // The unit vector that the light travels along.
    direction: vec3f,
    color: vec3f,
}

@group(0) @binding(132) var<storage, read> directional_lights: array<DirectionalLight>;

fn lit_by_directional(material: Material, color: vec3f, x: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < arrayLength(&directional_lights); i++) {
        work += 1u;
        sum += directional_lights[i].color * blinn_phong(material, color, -directional_lights[i].direction, normal, view);
    }
    return sum;
}
