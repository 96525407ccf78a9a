// A path's last step: kept until the path's end is looked for in the same pass, or taken again from where it began.

var<private> kept_end: Ray;

fn keep_end(next: Ray) {
    kept_end = next;
}

fn last_step(ray: Ray) -> LastStep {
    if KEEPS_LAST {
        return LastStep(ray.phase, ray.tau, own_size(ray, kept_end), kept_end.phase, kept_end.tau);
    }
    let next = accepted_step(ray);
    return LastStep(ray.phase, ray.tau, own_size(ray, next), next.phase, next.tau);
}
