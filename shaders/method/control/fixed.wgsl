// Steps of one size h, shorter where η · scale is less.

struct Control {
    step: Real,
    // The factor η of the limit h ≤ η · scale.
    eta: Real,
}

var<uniform> control: Control;

fn planned_step(p: Phase) -> Real {
    return min(control.step, control.eta * law_scale(p));
}
