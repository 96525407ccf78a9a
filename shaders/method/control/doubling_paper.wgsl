// The paper's rule (W04 §4.2): the difference changes only the next step, by two thresholds; no step is rejected.
// What would have been is counted: a step over the tolerance is kept, and its error with it.

// No step is taken back, so that the first has to be small; it doubles soon enough.
const FIRST: Real = 1e-3;

fn first_step(p: Phase) -> Real {
    return FIRST * control.eta * law_scale(p);
}

fn accepted_step(ray: Ray) -> Ray {
    let h = capped_step(ray);
    let step = doubled_step(ray.phase, h);
    var next = after_step(ray, law_projected(step.end), h);
    next.rejected += u32(step.error > control.tolerance);
    next.memory.h = h * select(select(Real(1.0), 2.0, step.error < control.grow_below), 0.5, step.error > control.tolerance);
    return next;
}
