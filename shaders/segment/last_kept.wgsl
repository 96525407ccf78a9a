// A path's last step is kept until the path's end is looked for, in the same pass.

var<private> kept_end: Ray;

fn keep_end(next: Ray) {
    kept_end = next;
}

fn last_step(ray: Ray) -> LastStep {
    return LastStep(ray.phase, ray.tau, own_size(ray, kept_end), kept_end.phase, kept_end.tau);
}
