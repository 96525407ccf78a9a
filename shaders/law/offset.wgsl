// Computes the vector from a source to a position, from d, the vector from the source's point, and `along`, its direction.

// From a center: the whole of d = x - p.
fn offset_center(d: Real3, along: Real3) -> Real3 {
    return d;
}

// From a line: the component of d = x - p that is perpendicular to its unit direction (G95 §2.1).
fn offset_line(d: Real3, along: Real3) -> Real3 {
    return d - dot(d, along) * along;
}

// From a black hole of spin `along`: a vector with the length of the Boyer–Lindquist r, normal to the spheroid of constant r.
fn offset_spheroid(d: Real3, along: Real3) -> Real3 {
    let spheroid = spheroid_of(d, along);
    return spheroid.x * normalize(spheroid.x * d + (spheroid.z / spheroid.x) * along);
}
