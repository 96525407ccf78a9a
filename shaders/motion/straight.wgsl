// Straight lines need no solver: one step leads to just outside the bounding sphere.

fn retaken_step(p: Phase, h: Real) -> Phase {
    return Phase(p[0] + h * p[1], p[1]);
}

fn accepted_step(ray: Ray) -> Ray {
    let v = ray.phase[1];
    let d = ray.phase[0] - bound.center;
    let vv = dot(v, v);
    let b = dot(d, v) / vv;
    let miss = d - b * v;
    let inside = max(bound.radius * bound.radius - dot(miss, miss), 0.0);
    let exit = -b + sqrt(inside / vv) + 1e-3 * bound.radius * inverseSqrt(vv);
    let h = limited_step(exit, ray);
    return after_step(ray, retaken_step(ray.phase, h), h);
}
