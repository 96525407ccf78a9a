// Step doubling that keeps its promise: a step whose difference exceeds the tolerance is tried again, shorter. The next size
// is the one whose leading error term would just meet the tolerance, with a safety factor and limits on its change (Hairer,
// Nørsett, Wanner, Solving ODEs I, §II.4). A ray that no try moves is stalled; or it has
// failed, if the shortest way on leads to where the law has no finite value.

const MAX_TRIES: u32 = 16u;
const SAFETY: Real = 0.9;
const MIN_FACTOR: Real = 0.2;
const MAX_FACTOR: Real = 5.0;

fn first_step(p: Phase) -> Real {
    return control.eta * law_scale(p);
}

fn step_factor(error: Real) -> Real {
    // A factor needs no more digits than f32 has.
    let ratio = f32(control.tolerance / max(error, 1e-30));
    return clamp(SAFETY * Real(pow(ratio, 1.0 / (STEP_ORDER + 1.0))), MIN_FACTOR, MAX_FACTOR);
}

fn accepted_step(ray: Ray) -> Ray {
    var next = ray;
    var h = capped_step(ray);
    var lost = false;
    next.taken = 0.0;
    for (var tries = 0u; tries < MAX_TRIES; tries++) {
        let step = doubled_step(ray.phase, h);
        if step.error <= control.tolerance {
            next.phase = opaque_phase(law_projected(step.end));
            next = later(next, h);
            next.taken = opaque(h);
            next.memory.h = h * step_factor(step.error);
            next.steps += 1u;
            break;
        }
        next.rejected += 1u;
        lost = lost || !finite_phase(step.end);
        h *= select(MIN_FACTOR, min(step_factor(step.error), 0.9), step.error < 1e30);
    }
    return failed_if(lost, ray, next);
}
