// Matte surfaces alone: Lambert's law, f = rho/pi.

// f cos theta for light that comes from `way`.
fn answered(vertex: PathVertex, way: vec3f) -> vec3f {
    return answer_density(vertex, way) * vertex.answer.diffuse;
}

// Of a direction that the surface chooses, per solid angle.
fn answer_density(vertex: PathVertex, way: vec3f) -> f32 {
    return max(dot(vertex.normal, way), 0.0) / f32(PI);
}

fn answer_way(vertex: PathVertex, u: vec2f, choice: f32) -> vec3f {
    return way_about(vertex.normal, sqrt(1.0 - u.x), sqrt(u.x), u.y);
}

// Is it worth to aim from here?
fn answers_widely(vertex: PathVertex) -> bool {
    return true;
}
