// Embedded pairs under a PI controller (Hairer, Nørsett, Wanner, Solving ODEs I, §II.4; Gustafsson 1991), with the names of their DOPRI5. A
// step whose error exceeds the tolerance is repeated with a smaller size; the next size follows from this error and the last one; and h ≤ η
// · scale, without which a controller far from a black hole sees flat space, grows the step, and jumps over it. A ray that no try moves is
// stalled; it has failed if the shortest step leads to a position where the law has no finite value.

struct Control {
    // The tolerance of the whole path's error: positions relative to the length of the law, velocities to the speed.
    tolerance: Real,
    // The factor η of the limit h ≤ η · scale.
    eta: Real,
}

var<uniform> control: Control;

// One step of an embedded pair.
struct PairStep {
    end: Phase,
    // The difference of the two methods.
    error: Phase,
    // The rate at the end, which is the first rate of the next step.
    rate: Phase,
}

const MAX_TRIES: u32 = 16u;
const SAFETY: f32 = 0.9;
// h shrinks by a factor of FAC1 at most, and grows by a factor of FAC2 at most.
const FAC1: f32 = 0.2;
const FAC2: f32 = 10.0;
const BETA: f32 = 0.04;
// The share of the tolerance that one step may use. A path has tens of steps and their errors add, so that the tolerance is about the error
// of the whole path where it does not diverge.
const SHARE: Real = 0.1;

// Returns the divisor of the step size. A factor needs no more digits than f32 has.
fn error_factor(error: f32) -> f32 {
    return pow(max(error, 1e-10), 1.0 / STEP_ORDER - 0.75 * BETA);
}

fn first_step(p: Phase) -> Real {
    return control.eta * law_scale(p);
}

fn retaken_step(p: Phase, h: Real) -> Phase {
    return law_projected(pair_step(p, law_derivative(p), h).end);
}

// Returns the error in units of the tolerance.
fn scaled_error(p: Phase, difference: Phase) -> f32 {
    let error = length(difference[0].xyz) / law_scale(p) + length(difference[1].xyz);
    return f32(error / (SHARE * control.tolerance * length(p[1].xyz)));
}

fn accepted_step(ray: Ray) -> Ray {
    var next = ray;
    var h = limited_step(min(ray.memory.h, control.eta * law_scale(ray.phase)), ray);
    var longest = FAC2;
    var lost = false;
    next.taken = 0.0;
    for (var tries = 0u; tries < MAX_TRIES; tries++) {
        let step = pair_step(ray.phase, ray.memory.rate, h);
        let error = scaled_error(ray.phase, step.error);
        let factor = error_factor(error);
        if error <= 1.0 {
            next.phase = opaque_phase(law_projected(step.end));
            next = later(next, h);
            next.taken = opaque(h);
            next.steps += 1u;
            let pi = factor / pow(f32(ray.memory.error), BETA) / SAFETY;
            next.memory.h = h * Real(min(1.0 / clamp(pi, 1.0 / FAC2, 1.0 / FAC1), longest));
            next.memory.error = Real(max(error, 1e-4));
            next.memory.rate = step.rate;
            break;
        }
        next.rejected += 1u;
        lost = lost || !finite_phase(step.end);
        // A value that is not a number also fails this comparison.
        h *= Real(select(FAC1, max(FAC1, SAFETY / factor), error < 1e30));
        // A step that follows a rejection does not grow.
        longest = 1.0;
    }
    return failed_if(lost, ray, next);
}
