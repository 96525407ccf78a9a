// Steps of an iteration, all of one size: its result is accepted without an error estimate.

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
