// Where a path ends: where its last step does.

fn path_end(ray: Ray, hit: Hit) -> PathPoint {
    let x = ray.phase[0].xyz;
    let v = ray.phase[1].xyz;
    let unfollowed = ray.status == ALIVE || ray.status == MISSED || ray.status == OUTSIDE || ray.status == FAILED;
    if unfollowed || (ray.status == CAPTURED && law_captured(x, v)) {
        let far = departed(ray.status, x, v);
        return PathPoint(far[0], far[1], ray.tau, 0.0);
    }
    let step = last_step(ray);
    let far = departed(ray.status, step.end[0].xyz, step.end[1].xyz);
    return PathPoint(far[0], far[1], step.end_tau, 1.0);
}
