// Round a wormhole, where clocks at rest go as they do far away.

// −g_tt.
fn law_clock(x: Real3) -> Real {
    return 1.0;
}

// Of light that goes into the past from x along d, but for a factor.
fn law_momentum(x: Real3, d: Real3) -> Real4 {
    let y = mouth_offset(x);
    let away = length(y);
    let n = y / away;
    let wider = throat_radius(away - law.radius).x / away;
    let radial = dot(d, n);
    let across = wider * (d - radial * n);
    return Real4(radial * n + wider * across, sqrt(radial * radial + dot(across, across)));
}
