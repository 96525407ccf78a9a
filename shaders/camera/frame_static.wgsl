// Converts directions in the frame of a static observer outside a Schwarzschild black hole to velocities: radial lengths are shorter in
// coordinates by √(1 − 2M/r).

fn frame_velocity(x: Real3, d: Real3) -> Real3 {
    let r = length(x - law.center);
    let n = (x - law.center) / r;
    let radial = dot(d, n);
    return d + (sqrt(1.0 - 2.0 * law.mass / r) - 1.0) * radial * n;
}
