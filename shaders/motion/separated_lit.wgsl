// Separated orbits through volumes: the steps of motion/separated_open, with the light of a stretch of several of them added at once. The
// stretch is followed before its light, so that steps far from all volumes are followed together.

// True if the path has ended, and adds no more light.
var<private> follows_ended: bool;

// A path from the start of its stretch: its size and the number of its steps.
struct LitWalk {
    here: Orbit,
    // The next step, and the longest that it may be after a cut.
    s: Real,
    longest: Real,
    cuts: u32,
    steps: u32,
    passed: Real,
    size: Real,
    within: u32,
    // False if the path is below the capture sphere, where nothing is seen.
    seen: bool,
}

fn lit_walk(ray: Ray) -> LitWalk {
    let here = orbit_of(ray.phase[0], ray.phase[1]);
    let s = orbit_stride(here, control.eta, here.u);
    return LitWalk(here, s, s, 0u, 0u, 0.0, 0.0, 0u, true);
}

fn lit_walk_step(before: LitWalk) -> LitWalk {
    var walk = before;
    let end = orbit_step(walk.here, walk.s);
    let stop = orbit_stop(end);
    let beyond = (end.u - stop) * end.w > 0.0;
    let crosses = (walk.cuts > 0u) | ((walk.here.u - stop) * end.w < 0.0);
    walk.cuts += select(0u, select(CUTS + 1u, 1u, crosses), beyond | (walk.cuts > 0u));
    walk.seen = crosses | !beyond;
    if (walk.cuts == 0u) | (walk.cuts > CUTS) {
        walk.passed += orbit_time(walk.here, end, walk.s);
        walk.here = end;
        walk.steps += 1u;
        walk.size += walk.s;
        walk.within += 1u;
    }
    let cut = clamp(walk.s - (end.u - stop) / end.w, 0.0, walk.longest);
    walk.s = select(cut, orbit_stride(walk.here, control.eta, walk.here.u), walk.cuts == 0u);
    walk.longest = select(walk.longest, walk.s, walk.cuts == 0u);
    return walk;
}

// Returns `true` if a stretch is outside the sphere around the black hole that contains all volumes.
fn lit_outside(a: Orbit, b: Orbit, s: Real) -> bool {
    return max(a.u, b.u) + 0.25 * s * max(a.w - b.w, 0.0) < transfer.edge;
}

// Follows a segment between two slots of the state, and stores its light.
fn lit_segment(pixel: vec2u, ray: Ray) -> Ray {
    load_throughput(pixel);
    begin_transfer(pixel);
    let next = lit_step(ray);
    keep_transfer(pixel);
    store_throughput(pixel);
    return next;
}

// The loops are tested at their ends, because software drivers run the rest of a loop's body once more after a test at its start.
fn lit_step(ray: Ray) -> Ray {
    var walk = lit_walk(ray);
    var done = false;
    loop {
        var mark = walk.here;
        var tau = ray.tau + walk.passed;
        walk.size = 0.0;
        walk.within = 0u;
        loop {
            walk = lit_walk_step(walk);
            if lit_outside(mark, walk.here, walk.size) {
                mark = walk.here;
                tau = ray.tau + walk.passed;
                walk.size = 0.0;
                walk.within = 0u;
            }
            done = (walk.cuts > CUTS) | (walk.steps >= STEPS);
            continuing {
                break if done | (f32(walk.within + 1u) * f32(control.eta) > transfer.arc) & (walk.cuts == 0u);
            }
        }
        if walk.seen && walk.size > 0.0 && !follows_ended {
            transfer_step(stretch_between(mark, walk.here, walk.size, tau), 1.0);
        }
        // The rest of a path with much light follows in another pass.
        rejoin();
        done = done | ((walk.cuts == 0u) & !has_room());
        continuing {
            break if done;
        }
    }
    let end = orbit_point(walk.here);
    // A path that rounding leaves above the capture sphere is followed once more.
    if HAS_HORIZON {
        if (walk.cuts > CUTS) & walk.seen & !follows_ended & law_captured(end[0].xyz, end[1].xyz) {
            transfer_tail(stretch_from(walk.here, ray.tau + walk.passed), 0.0);
        }
    }
    var next = after_step(ray, end, walk.passed);
    next.steps = ray.steps + walk.steps;
    return next;
}
