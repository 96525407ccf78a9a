// Stores the results of passes over segments: the rays, and the counts. Called by every lane of the group.

// Stores the results of steps. before: the ray at the start of the pass.
fn finish_steps(spot: ActiveRay, before: Ray, next: Ray, lane: u32) {
    if spot.alive {
        let ray = known_ray(next);
        store_ray(spot.pixel, ray);
        store_counts(spot.pixel, ray);
        store_taken(spot.pixel, ray.taken);
        tally_steps(ray.steps - before.steps);
        tally_rejections(ray.rejected - before.rejected);
    }
    workgroupBarrier();
    total_steps(lane);
    total_rejections(lane);
}

// Stores the results of whole segments. end: the hit of the ray, if it ended on a surface.
fn finish_advance(spot: ActiveRay, before: Ray, ray: Ray, end: Hit, lane: u32) {
    let lives = spot.alive && ray.status == ALIVE;
    if spot.alive {
        store_ray(spot.pixel, ray);
        store_counts(spot.pixel, ray);
        store_status(spot.pixel, status_word(ray.status, dispatch.end, ray.index));
        if ends_on_surface(ray.status) {
            store_hit(spot.pixel, end);
        } else {
            store_last_hit(spot.pixel, ray.index);
        }
        store_region(spot.pixel);
        store_throughput(spot.pixel);
        if AIMS {
            store_waiting(spot.pixel);
        }
        store_branches(spot.pixel);
        tally_steps(ray.steps - before.steps);
        tally_segments(ray.index - before.index + u32(!lives));
        tally_rejections(ray.rejected - before.rejected);
    }
    keep_active(lives, spot.pixel, lane);
    total_steps(lane);
    total_segments(lane);
    total_rejections(lane);
}
