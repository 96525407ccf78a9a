// Where rays stop when a segment is a chord over several steps: hits lie on the chord, as in the paper.

fn segment_end(ray: Ray, hit: Hit, step: LastStep) -> PathPoint {
    let t = select(1.0, hit.t, ray.status == HIT);
    let x = mix(ray.phase[0].xyz, step.end[0].xyz, t);
    let v = mix(ray.phase[1].xyz, step.end[1].xyz, t);
    return PathPoint(x, v, mix(ray.tau, step.end_tau, t), t);
}
