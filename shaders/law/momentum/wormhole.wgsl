// The momentum of light around a wormhole, where static clocks run as fast as far away.

// Returns the momentum of light that leaves x into the past with velocity v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    let y = mouth_offset(x);
    let away = length(y);
    let n = y / away;
    let wider = throat_radius(away - law.radius).x / away;
    let radial = dot(v, n);
    let across = wider * (v - radial * n);
    return Real4(radial * n + wider * across, sqrt(radial * radial + dot(across, across)));
}

// Returns the position of x relative to the center of symmetry of the law.
fn law_arm(x: Real3) -> Real3 {
    return mouth_offset(x);
}

// Returns g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    let y = mouth_offset(x);
    let away = length(y);
    let n = y / away;
    let wider = throat_radius(away - law.radius).x / away;
    let radial = dot(k.xyz, n);
    let across = wider * (k.xyz - radial * n);
    return radial * radial + dot(across, across) - k.w * k.w;
}

// Returns the four-velocity of the Eulerian observer, who is static.
fn law_eulerian(x: Real3) -> Real4 {
    return Real4(0.0, 0.0, 0.0, 1.0);
}
