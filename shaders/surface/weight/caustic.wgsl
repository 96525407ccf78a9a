// As of a light's rays, but below 0 until a surface has sent a ray on: before that it leaves no light.

fn start_weight(x: Real3) {
    weight = -1.0;
}

fn note_sent() {
    weight = abs(weight);
}

fn scale_weight(factor: vec3f) -> f32 {
    weight *= (factor.x + factor.y + factor.z) / 3.0;
    return weight;
}

fn end_weight(x: Real3) -> vec3f {
    return vec3f(light_weight());
}

fn light_weight() -> f32 {
    return max(weight, 0.0);
}
