// Steps h = η · scale: a fixed fraction of the length over which the law changes.

struct Control {
    eta: Real,
}

var<uniform> control: Control;

fn planned_step(p: Phase) -> Real {
    return control.eta * law_scale(p);
}
