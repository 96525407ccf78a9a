// As surface/weight/colored.wgsl, where nothing on the way has a colour.

fn start_weight(x: Real3) {
    let n = medium_index(x);
    weight = f32(n * n);
}

fn scale_weight(factor: vec3f) -> f32 {
    weight *= factor.x;
    return weight;
}

fn end_weight(x: Real3) -> vec3f {
    let n = medium_index(x);
    return sure_weight(vec3f(weight / f32(n * n)));
}

// Where a path began or ended in the middle of an infinite index its light is none.
fn sure_weight(weight: vec3f) -> vec3f {
    return select(vec3f(0.0), weight, finite(Real3(weight)));
}
