// Ends every ray at the first surface that it meets.

fn may_scatter(code: u32) -> bool {
    return false;
}

fn scatter_ray(ray: Ray, met: ptr<function, Hit>, pixel: vec2u) -> Ray {
    return ray;
}
