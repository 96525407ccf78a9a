// Step doubling: one step h compared with two of h/2 (W04 §4.2), and an upper limit, without which a controller far from a black hole sees
// flat space, grows the step, and jumps over it.
//
// A step whose difference exceeds the tolerance is repeated with a smaller size. The next size is the one whose leading error term would
// just meet the tolerance, with a safety factor and limits on its change (Hairer, Nørsett, Wanner, Solving ODEs I, §II.4). A ray that no
// try moves is stalled; it has failed if the shortest step leads to a position where the law has no finite value. By the rule of W04 §4.2
// the difference changes only the next step, by two thresholds: a step over the tolerance is counted and kept with its error.

const MAX_TRIES: u32 = 16u;
const SAFETY: Real = 0.9;
const MIN_FACTOR: Real = 0.2;
const MAX_FACTOR: Real = 5.0;
// The first step has to be small if no step is rejected; it doubles soon enough.
const FIRST: Real = 1e-3;

struct Control {
    // h shrinks above this error.
    tolerance: Real,
    // h grows below this error.
    grow_below: Real,
    // The factor η of the limit h ≤ η · scale.
    eta: Real,
}

var<uniform> control: Control;

struct DoubledStep {
    // The result of the two half steps, kept without extrapolation.
    end: Phase,
    // The relative difference from one whole step: positions relative to the length of the law, velocities to the speed.
    error: Real,
}

fn capped_step(ray: Ray) -> Real {
    return limited_step(min(ray.memory.h, control.eta * law_scale(ray.phase)), ray);
}

// The loops keep a single copy of the step in the program, because drivers inline every call.
fn half_steps(p: Phase, h: Real) -> Phase {
    var q = p;
    for (var half = 0u; half < 2u; half++) {
        q = step_ray(q, 0.5 * h);
    }
    return q;
}

fn doubled_step(p: Phase, h: Real) -> DoubledStep {
    var whole = p;
    var halves = p;
    for (var k = 0u; k < 3u; k++) {
        let q = step_ray(halves, select(0.5 * h, h, k == 0u));
        if k == 0u {
            whole = q;
        } else {
            halves = q;
        }
    }
    let difference = halves - whole;
    let error = length(difference[0].xyz) / law_scale(p) + length(difference[1].xyz);
    return DoubledStep(halves, error / length(p[1].xyz));
}

fn retaken_step(p: Phase, h: Real) -> Phase {
    return law_projected(half_steps(p, h));
}

fn first_step(p: Phase) -> Real {
    if KEEPS_ERRORS {
        return FIRST * control.eta * law_scale(p);
    }
    return control.eta * law_scale(p);
}

fn step_factor(error: Real) -> Real {
    // A factor needs no more digits than f32 has.
    let ratio = f32(control.tolerance / max(error, 1e-30));
    return clamp(SAFETY * Real(pow(ratio, 1.0 / (STEP_ORDER + 1.0))), MIN_FACTOR, MAX_FACTOR);
}

fn accepted_step(ray: Ray) -> Ray {
    if KEEPS_ERRORS {
        let h = capped_step(ray);
        let step = doubled_step(ray.phase, h);
        var next = after_step(ray, law_projected(step.end), h);
        next.rejected += u32(step.error > control.tolerance);
        next.memory.h = h * select(select(Real(1.0), 2.0, step.error < control.grow_below), 0.5, step.error > control.tolerance);
        return next;
    }
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
