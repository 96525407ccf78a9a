// Surfaces that lie on each other are met as one: light goes from the medium before all of them to the medium behind all of them,
// and what is opaque ends or reflects it. A ray meets one of them first by rounding alone; which others are there is asked of the
// point where it does.

// An object that touches another: first those that are opaque, then those that light goes through.
struct Touching {
    // Elements of a uniform array lie 16 bytes apart.
    @align(16) primitive: u32,
    // The object as a set of its own, where light goes through it.
    bits: u32,
}

var<uniform> touching: array<Touching, TOUCHING_COUNT>;

// Surfaces are together that are no further apart than this part of the sizes from which their gaps are computed. In 32 bits each
// gap is wrong by up to fifteen roundings (of the place, the rows and the sum), and 2e-6 are thirty; in 64 bits it is for scenes
// in which numbers are written with a few digits, and such a gap is none to light.
const TOGETHER: Real = 2e-6;

// Surfaces with a larger angle between them cross, and are together in a strip no wider than some twenty such gaps.
const PARALLEL: Real = 0.999;

// The cosine between the normals where both surfaces are together in x, else 0. What x itself is off by, after a long way, is the
// same for both.
fn alignment(a: Surface, b: Surface, x: Real3) -> Real {
    let cosine = dot(a.across, b.across);
    let apart = abs(b.gap - sign(cosine) * a.gap);
    let together = apart <= TOGETHER * (length(x) + a.depth + b.depth);
    return select(0.0, cosine, together && abs(cosine) >= PARALLEL);
}

// The surface at x, where `met` was met: of those that are together there, the opaque one, which `met` then names.
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

// The set of a ray once it is through the surface at x, that of the object `own`: a ray that leaves this one goes along its normal,
// leaves what has the same normal, and enters what has the opposite one.
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
