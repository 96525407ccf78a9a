// Paths aim at nothing: they find light by themselves.

fn may_scatter(code: u32) -> bool {
    return code == HIT;
}

fn after_flight(leg: Leg, code: u32) -> Leg {
    return leg;
}

fn left_vertex(vertex: PathVertex, onward: vec3f, density: f32, weight: vec3f, pixel: vec2u) -> Leg {
    carried.scatterings += 1u;
    return own_leg(vertex.x, vertex.speed * Real3(onward), vertex.tau, weight, HIT);
}
