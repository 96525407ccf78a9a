// Carries rays through the throat of a wormhole. A path crosses it like any other position, and continues to a sphere slightly beyond, l =
// −δ. From there it is drawn around the other mouth, where this is l = δ, in the same direction. Between the two no chord of an arc leads
// back.

const THROAT: u32 = 11u;

// Returns the scale of R from one drawing to the other.
fn other_drawing(x: Real3) -> Real {
    return 2.0 * law.radius / length(mouth_offset(x)) - 1.0;
}

fn scatter_throat(material: Material, surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let inwards = dot(end.v, surface.normal) * surface.normal;
    return Scattered(other_drawing(end.x) * (end.v - inwards) - inwards, vec3f(1.0), false, true);
}

// Moves a ray to the other mouth.
fn pass_throat(kind: u32, x: ptr<function, Real3>) {
    if kind == THROAT {
        let is_here = distance(*x, law.center) < distance(*x, law.other);
        *x = select(law.center, law.other, is_here) + other_drawing(*x) * mouth_offset(*x);
    }
}
