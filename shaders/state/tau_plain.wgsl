// The path's parameter is summed as it is: where nothing ends by it, or in numbers of 64 bits.

fn later(ray: Ray, passed: Real) -> Ray {
    var next = ray;
    // One by one: compilers may sum up those of several steps otherwise where a program goes on otherwise.
    next.tau = opaque(ray.tau + passed);
    return next;
}

fn load_rest(pixel: vec2u) -> Real {
    return 0.0;
}

fn ended_rest(slot: u32, pixel: vec2u) -> Real {
    return 0.0;
}

fn store_rest(pixel: vec2u, ray: Ray) {
}
