// Reflects and refracts rays at the surface of a transparent object: between the medium on this side and the medium on the other, which may
// be equal if a medium of higher priority is on both.

const TRANSMISSIVE: u32 = 3u;

fn scatter_transmissive(material: Material, surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let bits = inside;
    let near_medium = medium_object();
    let n1 = medium_index(end.x);
    enter_set(set_beyond(1u << material.bit, surface, end.x));
    let n2 = medium_index(end.x);
    if medium_object() == near_medium {
        return Scattered(end.v, vec3f(1.0), false, true);
    }
    let both = refraction(n1 * normalize(end.v), surface.normal, n1, n2);
    var taken = Branch(both.reflectance > 0.5, 1.0, false);
    if both.reflectance > 0.0 && both.reflectance < 1.0 {
        taken = chosen_branch(pixel, index, f32(both.reflectance));
    }
    if taken.reflects {
        enter_set(bits);
    }
    return Scattered(select(both.transmitted, both.reflected, taken.reflects), vec3f(taken.throughput), taken.cut, true);
}

// Snell's law and the Fresnel equations, in the velocity v = n d: the component along the surface is constant, and the normal component of
// the transmitted ray follows from the new length (T Eqs. 2–7).
struct Refraction {
    // The reflectance for unpolarized light: 1 at total internal reflection, 0 if the indices agree.
    reflectance: Real,
    // The transmitted velocity, with the index beyond as its length.
    transmitted: Real3,
    reflected: Real3,
}

// v: of length n1, onto a surface with this unit normal, to either side.
fn refraction(v: Real3, normal: Real3, n1: Real, n2: Real) -> Refraction {
    let through = dot(v, normal);
    let along = v - through * normal;
    let a = abs(through);
    let matched = abs(n2 * n2 - n1 * n1) <= MATCHED * n1 * n1;
    let left = n2 * n2 - dot(along, along);
    let b = sqrt(max(left, 0.0));
    // With n₁ cos θᵢ = a and n₂ cos θₜ = b, r⊥ = (a − b)/(a + b) and r∥ = (n₂² a − n₁² b)/(n₂² a + n₁² b).
    let perpendicular = (a - b) / max(a + b, 1e-30);
    let parallel = (n2 * n2 * a - n1 * n1 * b) / max(n2 * n2 * a + n1 * n1 * b, 1e-30);
    let partial = 0.5 * (perpendicular * perpendicular + parallel * parallel);
    let total = left <= 0.0;
    let reflectance = select(select(partial, Real(1.0), total), Real(0.0), matched);
    let straight = (n2 / n1) * v;
    let bent = along + select(b, -b, through < 0.0) * normal;
    return Refraction(reflectance, select(bent, straight, matched), v - (2.0 * through) * normal);
}
