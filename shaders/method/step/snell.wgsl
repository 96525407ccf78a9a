// Discrete refraction (W04 §5.3 after Yngve et al. 2000): straight steps, and where the index has changed by more than a threshold since
// the last refraction, Snell's law at a plane with its normal along ∇n. |v| stores the index of that last refraction, so that no state is
// added; beyond the critical angle the ray is reflected.

struct Snell {
    threshold: Real,
}

var<uniform> snell: Snell;

const STEP_ORDER: f32 = 1.0;

fn step_ray(p: Phase, h: Real) -> Phase {
    let x = p[0] + h * p[1];
    let v = p[1];
    let n = medium_index(x);
    let pull = medium_pull(x);
    let last = length(v);
    let steep = dot(pull, pull) > 0.0;
    let normal = select(Real3(0.0), normalize(pull), steep);
    // n d keeps its component along the plane; the normal component follows from the new length.
    let along = dot(v, normal);
    let across = v - along * normal;
    let through2 = n * n - dot(across, across);
    let through = sign(along) * sqrt(max(through2, 0.0));
    let refracted = across + select(-along, through, through2 > 0.0) * normal;
    let turns = steep && abs(n - last) > snell.threshold;
    return Phase(x, select(v, refracted, turns));
}
