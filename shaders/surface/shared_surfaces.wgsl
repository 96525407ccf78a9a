// Treats surfaces that touch each other as one: light passes from the medium before all of them to the medium behind all of them, and an
// opaque one ends or reflects it. Which of them a ray hits first depends on rounding alone; the others are found at the position of that
// hit.

// An object that touches another: first the opaque ones, then the transparent ones.
struct Touching {
    // Elements of a uniform array are 16 bytes apart.
    @align(16) primitive: u32,
    // The object as a set with one bit, if it is transparent.
    bits: u32,
}

var<uniform> touching: array<Touching, TOUCHING_COUNT>;

// The distance, relative to the sizes from which signed distances are computed, up to which surfaces touch. In 32 bits each gap is wrong by up to
// fifteen roundings (of the position, the rows and the sum), and 2e-6 is thirty; in 64 bits it serves scenes whose numbers are written with
// a few digits, and such a gap does not exist for light.
const TOGETHER: Real = 2e-6;

// Surfaces with a larger angle between them cross, and touch in a strip of a width of at most about twenty such signed distances.
const PARALLEL: Real = 0.999;

// Returns the cosine between the normals if both surfaces touch at x, else 0. The error of x itself, after a long path, is equal for both.
fn alignment(a: Surface, b: Surface, x: Real3) -> Real {
    let cosine = dot(a.normal, b.normal);
    let apart = abs(b.signed_distance - sign(cosine) * a.signed_distance);
    let together = apart <= TOGETHER * (length(x) + a.depth + b.depth);
    return select(0.0, cosine, together && abs(cosine) >= PARALLEL);
}

// Returns the surface at x, where `met` was hit: of those that touch there the opaque one, which is then stored in `met`.
fn met_surface(met: ptr<function, Hit>, x: Real3) -> Surface {
    if !TOUCHES {
        return hit_surface((*met).primitive, x);
    }
    let first = hit_surface((*met).primitive, x);
    for (var i = 0u; i < TOUCHING_OPAQUE; i++) {
        let other = hit_surface(touching[i].primitive, x);
        // Flat shapes have an edge.
        let reaches = all(other.uv >= vec2f(0.0)) && all(other.uv <= vec2f(1.0));
        if reaches && alignment(first, other, x) != 0.0 {
            (*met).primitive = touching[i].primitive;
        }
    }
    return hit_surface((*met).primitive, x);
}

// Returns the set of a ray after it has passed the surface of the object `own` at x: a ray that leaves this surface moves along its normal,
// leaves objects with the same normal, and enters objects with the opposite one.
fn set_beyond(own: u32, surface: Surface, x: Real3) -> u32 {
    if !TOUCHES {
        return inside ^ own;
    }
    let leaves = (inside & own) != 0u;
    var bits = inside ^ own;
    for (var i = TOUCHING_OPAQUE; i < TOUCHING_COUNT; i++) {
        let other = touching[i];
        let cosine = alignment(surface, hit_surface(other.primitive, x), x);
        let enters = (cosine < 0.0) == leaves;
        bits = select(bits, select(bits & ~other.bits, bits | other.bits, enters), cosine != 0.0);
    }
    return bits;
}
