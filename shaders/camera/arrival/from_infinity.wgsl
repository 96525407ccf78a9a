// Given rays from outside the bounding sphere come from infinity: they are lines there, and start on the sphere where the orbit
// with that asymptote does. One that misses it is taken up on its way in, well before its nearest point.

fn arrived(ray: CameraRay) -> CameraRay {
    let y = ray.x - bound.center;
    let entry = bound_entry(ray.x, ray.d);
    // Rays on the sphere, but for rounding, are inside.
    if dot(y, y) <= bound.radius * bound.radius * (1.0 + 1e-6) {
        return ray;
    }
    let o = orbit_from_infinity(ray.x, ray.d);
    let well_before = min(0.5 / bound.radius, 0.5 * o.w / max(o.h, 1e-30));
    let aim = select(1.0 / bound.radius, well_before, entry < 0.0);
    return arriving(o, aim, entering(ray.status, entry < 0.0));
}
