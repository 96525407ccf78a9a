// Paths aim at nothing: they find light by themselves.

fn may_scatter(code: u32) -> bool {
    return code == HIT;
}

fn met_nothing(ray: Ray, pixel: vec2u) -> Ray {
    return ray;
}

fn ended(ray: Ray, code: u32, pixel: vec2u) -> Ray {
    var next = ray;
    next.status = code;
    carried.flight = OVER;
    return next;
}

fn left_vertex(ray: Ray, vertex: PathVertex, onward: vec3f, density: f32, weight: vec3f, pixel: vec2u) -> Ray {
    carried.scatterings += 1u;
    return sent_on(ray, vertex.x, vertex.speed * Real3(onward), vertex.tau, weight);
}
