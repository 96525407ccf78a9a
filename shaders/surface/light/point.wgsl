// Point lights.

struct PointLight {
    position: vec3f,
    // 1 if it casts shadows.
    shadows: u32,
    color: vec3f,
    // 1 if it falls off with the square of the distance.
    falls: u32,
}

var<storage, read> point_lights: array<PointLight>;

fn lit_by_point(material: Material, color: vec3f, lit: Lit) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < arrayLength(&point_lights); i++) {
        let way = point_lights[i].position - lit.x;
        let to_light = normalize(way);
        let faces = dot(lit.normal, to_light) > 0.0;
        let end = Real3(point_lights[i].position) - lit.start;
        let strength = light_share(point_lights[i].shadows, faces, lit.start, end) * fallen(point_lights[i].falls, way);
        sum += strength * point_lights[i].color * blinn_phong(material, color, to_light, lit.normal, lit.view);
    }
    return sum;
}

// Returns the falloff with the square of the distance, if the light has one; at distance 1 a light has its specified intensity.
fn fallen(falls: u32, way: vec3f) -> f32 {
    if !FALLS {
        return 1.0;
    }
    return select(1.0, 1.0 / dot(way, way), falls == 1u);
}
