// What shooting finds (G95 §6, his open problem): a path from a light to a place.

struct Shot {
    found: bool,
    // Its unit direction at the light, and at the place.
    leaves: Real3,
    arrives: Real3,
    // The area that the bundle about it has at the place, square to it, for each solid angle at the light.
    spread: Real,
}

const NO_SHOT: Shot = Shot(false, Real3(0.0), Real3(0.0), 0.0);

// There is room for the next path, and for a step of it.
fn shot_has_room() -> bool {
    return work + 2u * schedule.segment_work + 512u < WORK_LIMIT;
}

// Two unit vectors square to d and to each other.
fn square_to(d: Real3) -> mat2x3<Real> {
    let other = select(Real3(1.0, 0.0, 0.0), Real3(0.0, 1.0, 0.0), abs(d.x) > 0.7);
    let a = normalize(cross(d, other));
    return mat2x3<Real>(a, cross(d, a));
}
