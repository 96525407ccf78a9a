// Where rays stop in a scene without objects.

fn segment_end(ray: Ray, hit: Hit, step: LastStep) -> PathPoint {
    return PathPoint(step.end[0].xyz, step.end[1].xyz, step.end_tau, 1.0);
}
