// Where rays start. Outside the bounding sphere space is flat: a camera's ray from there starts where it enters, on the line along which it
// comes to the camera; to an observer who moves it seems to come from elsewhere. Where the law goes on out there a camera sees along orbits,
// and rays that miss the sphere go on from the camera. Given rays start where they are, and only what moves away from outside the sphere
// never comes inside.

fn arrived(ray: CameraRay) -> CameraRay {
    if IS_GIVEN {
        if IS_ASYMPTOTIC {
            return arrived_from_infinity(ray);
        }
        return CameraRay(ray.x, ray.d, entering(ray.status, left_bound(ray.x, ray.d)));
    }
    let v = frame_velocity(ray.x, ray.d);
    let entry = bound_entry(ray.x, v);
    if IS_ASYMPTOTIC {
        if entry == 0.0 || entry < 0.0 {
            return CameraRay(ray.x, v, entering(ray.status, entry < 0.0));
        }
        return arriving(orbit_of(ray.x, v), 1.0 / bound.radius, ray.status);
    }
    let x = ray.x + max(entry, 0.0) * v;
    return CameraRay(x, v, entering(ray.status, entry < 0.0));
}

// Given rays from outside the bounding sphere come from infinity: they are lines there, and start on the sphere where the orbit
// with that asymptote does. One that misses it is taken up on its way in, well before its nearest point.
fn arrived_from_infinity(ray: CameraRay) -> CameraRay {
    let y = ray.x - bound.center;
    let entry = bound_entry(ray.x, ray.d);
    // A ray that starts on the sphere, to within rounding, is inside.
    if dot(y, y) <= bound.radius * bound.radius * (1.0 + 1e-6) {
        return ray;
    }
    let o = orbit_from_infinity(ray.x, ray.d);
    let well_before = min(0.5 / bound.radius, 0.5 * o.w / max(o.h, 1e-30));
    let aim = select(1.0 / bound.radius, well_before, entry < 0.0);
    return arriving(o, aim, entering(ray.status, entry < 0.0));
}
