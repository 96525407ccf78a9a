// What is left of a ray's light on its way from a lamp: the parts that surfaces reflect or let through, of all colours together.

fn start_weight(x: Real3) {
    weight = 1.0;
}

fn scale_weight(factor: vec3f) -> f32 {
    weight *= (factor.x + factor.y + factor.z) / 3.0;
    return weight;
}

fn end_weight(x: Real3) -> vec3f {
    return vec3f(weight);
}

fn light_weight() -> f32 {
    return weight;
}
