// Steps h = η · scale: a fixed fraction of the length over which the law changes.

struct Control {
    eta: f32,
}

@group(0) @binding(60) var<uniform> control: Control;

fn first_step(p: Phase) -> f32 {
    return 0.0;
}

fn retaken_step(p: Phase, h: f32) -> Phase {
    return law_settled(step_ray(p, h));
}

fn accepted_step(ray: Ray) -> Ray {
    let h = limited_step(control.eta * law_scale(ray.phase), ray.tau);
    var next = ray;
    next.phase = opaque_phase(retaken_step(ray.phase, h));
    next.tau += h;
    next.taken = opaque(h);
    next.steps += 1u;
    return next;
}
