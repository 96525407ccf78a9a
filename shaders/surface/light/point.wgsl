// Lights at a place, without fall-off.

struct PointLight {
    position: vec3f,
    color: vec3f,
}

@group(0) @binding(133) var<storage, read> point_lights: array<PointLight>;

fn lit_by_point(material: Material, color: vec3f, x: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < arrayLength(&point_lights); i++) {
        work += 1u;
        let to_light = normalize(point_lights[i].position - x);
        sum += point_lights[i].color * blinn_phong(material, color, to_light, normal, view);
    }
    return sum;
}
