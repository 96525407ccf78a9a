// Step doubling's parts: one step h against two of h/2 (W04 §4.2), and the cap without which a controller far from a hole
// sees flat space, grows, and jumps over it.

struct Control {
    // h shrinks above it.
    tolerance: Real,
    // h grows below it.
    grow_below: Real,
    // h ≤ η · scale.
    eta: Real,
}

var<uniform> control: Control;

struct DoubledStep {
    // The two half steps' result, kept without extrapolation.
    end: Phase,
    // The relative difference from one whole step: of positions over the law's length, of velocities over the speed.
    error: Real,
}

fn capped_step(ray: Ray) -> Real {
    return limited_step(min(ray.memory.h, control.eta * law_scale(ray.phase)), ray);
}

// The loops keep a single copy of the step in the program: drivers inline every call.
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
