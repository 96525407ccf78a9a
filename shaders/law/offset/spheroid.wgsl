// From a hole of spin `along`: as long as Kerr's r, and square to the spheroid on which that is the same.

fn offset_spheroid(d: Real3, along: Real3) -> Real3 {
    let spheroid = spheroid_of(d, along);
    return spheroid.x * normalize(spheroid.x * d + (spheroid.z / spheroid.x) * along);
}
