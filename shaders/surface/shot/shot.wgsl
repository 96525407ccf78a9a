// What shooting finds (G95 §6, his open problem): a path from a light to a place.

struct Shot {
    found: bool,
    // Its unit direction at the light, and at the place.
    leaves: Real3,
    arrives: Real3,
    // The area that the bundle about it has at the place, square to it, for each solid angle at the light.
    spread: Real,
    // What it misses the place by, as an angle at the light.
    error: Real,
}

const NO_SHOT: Shot = Shot(false, Real3(0.0), Real3(0.0), 0.0, 0.0);

// A search between two of its parts, each of which has room in an invocation.
struct ShotSearch {
    // As far as they are known.
    shot: Shot,
    // Where the path is nearest to the place: how far off, and its length up to there.
    offset: Real3,
    gap: Real,
    passed: Real,
    // How many parts are done, or that all are.
    parts: u32,
}

const SEARCHED: u32 = 64u;

// Two unit vectors square to d and to each other.
fn square_to(d: Real3) -> mat2x3<Real> {
    let other = select(Real3(1.0, 0.0, 0.0), Real3(0.0, 1.0, 0.0), abs(d.x) > 0.7);
    let a = normalize(cross(d, other));
    return mat2x3<Real>(a, cross(d, a));
}
