// Surfaces end the rays that meet them.

fn may_go_on(code: u32) -> bool {
    return false;
}

fn gone_on(ray: Ray, met: ptr<function, Hit>, pixel: vec2u) -> Ray {
    return ray;
}
