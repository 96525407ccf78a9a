// An iteration's own steps, of one size: what it makes of a state is taken as it is.

struct Control {
    step: Real,
}

var<uniform> control: Control;

fn first_step(p: Phase) -> Real {
    return 0.0;
}

fn retaken_step(p: Phase, h: Real) -> Phase {
    return step_ray(p, h);
}

fn accepted_step(ray: Ray) -> Ray {
    let h = limited_step(control.step, ray);
    return after_step(ray, retaken_step(ray.phase, h), h);
}
