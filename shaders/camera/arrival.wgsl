// Computes where rays start. Outside the bounding sphere space is flat: a ray from a camera there starts where it enters the sphere, on the
// line along which it reaches the camera. To a moving observer it seems to come from another direction. If the law continues beyond the
// sphere, a camera sees along orbits, and rays that miss the sphere continue from the camera. Given rays start where they are; only a ray
// that moves away from outside the sphere never comes inside.

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

// Starts a given ray from outside the bounding sphere at infinity. Such rays are lines there, and start on the sphere where the orbit with
// that asymptote meets it. A ray that misses the sphere starts on its inbound path, well before its nearest point.
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
