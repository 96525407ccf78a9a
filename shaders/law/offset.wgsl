// From what a source stands on to a place, d from its point and along its direction.

// From a centre: the way to a place is all of d = x - p.
fn offset_center(d: Real3, along: Real3) -> Real3 {
    return d;
}

// From a line: the part of d = x - p that is perpendicular to its unit direction (G95 §2.1).
fn offset_line(d: Real3, along: Real3) -> Real3 {
    return d - dot(d, along) * along;
}

// From a hole of spin `along`: as long as Kerr's r, and square to the spheroid on which that is the same.
fn offset_spheroid(d: Real3, along: Real3) -> Real3 {
    let spheroid = spheroid_of(d, along);
    return spheroid.x * normalize(spheroid.x * d + (spheroid.z / spheroid.x) * along);
}
