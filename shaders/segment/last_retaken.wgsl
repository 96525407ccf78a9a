// A path's last step is taken again from where it began.

fn last_step(ray: Ray) -> LastStep {
    let next = accepted_step(ray);
    return LastStep(ray.phase, ray.tau, own_size(ray, next), next.phase, next.tau);
}
