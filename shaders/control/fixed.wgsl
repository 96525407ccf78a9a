// Steps of one size h.

struct Control {
    step: f32,
}

@group(0) @binding(60) var<uniform> control: Control;

fn first_step(p: Phase) -> f32 {
    return control.step;
}

fn retaken_step(p: Phase, h: f32) -> Phase {
    return law_settled(step_ray(p, h));
}

fn accepted_step(ray: Ray) -> Ray {
    let h = limited_step(control.step, ray.tau);
    var next = ray;
    next.phase = opaque_phase(retaken_step(ray.phase, h));
    next.tau += h;
    next.taken = opaque(h);
    next.steps += 1u;
    return next;
}
