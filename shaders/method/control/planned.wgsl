// Steps whose size is known before they are taken.

fn first_step(p: Phase) -> Real {
    return 0.0;
}

fn retaken_step(p: Phase, h: Real) -> Phase {
    return law_projected(step_ray(p, h));
}

fn accepted_step(ray: Ray) -> Ray {
    let h = limited_step(planned_step(ray.phase), ray);
    return after_step(ray, retaken_step(ray.phase, h), h);
}
