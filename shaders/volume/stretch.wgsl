// A step of any motion, whose positions are retaken from its start.

struct Stretch {
    start: Phase,
    // The size, in the parameter of the step.
    h: Real,
    tau: Real,
}

fn stretch_of(ray: Ray, next: Ray) -> Stretch {
    return Stretch(ray.phase, own_size(ray, next), ray.tau);
}

fn stretch_last(step: LastStep) -> Stretch {
    return Stretch(step.phase, step.h, step.tau);
}

fn stretch_place(step: Stretch, f: Real) -> Real3 {
    return retaken_step(step.start, f * step.h)[0].xyz;
}

// Returns the change of the position per unit of the step's fraction.
fn stretch_way(step: Stretch, f: Real) -> Real3 {
    let p = retaken_step(step.start, f * step.h);
    return step.h * own_pace(p) * path_velocity(p[1].xyz);
}

// Returns the decrease of the radius per unit of the step's fraction.
fn stretch_fall(step: Stretch, f: Real) -> Real {
    return -dot(law_rise(law_arm(stretch_place(step, f))), stretch_way(step, f));
}

// Returns the position and the light at a fraction of a step.
fn stretch_spot(step: Stretch, f: Real) -> Spot {
    let p = retaken_step(step.start, f * step.h);
    let x = p[0].xyz;
    let v = path_velocity(p[1].xyz);
    var spot: Spot;
    spot.x = x;
    spot.higher = 1.0;
    let n = medium_index(x);
    spot.index = n * n;
    if PLACES_BY_LAW {
        let q = formula_axes(law_arm(x));
        spot.r = law_radius(law_arm(x));
        spot.cosine = clamp(q.z / max(spot.r, 1e-30), -1.0, 1.0);
        spot.sine = length(q.xy) / max(law_axial(spot.r), 1e-30);
    }
    if VOLUMES_CHANGE {
        spot.tau = step.tau + own_tau(step.start, p, f * step.h);
        spot.time = Real(transfer.time) - spot.tau;
    }
    let pace = own_pace(p) * step.h;
    if !SHIFTS_VOLUMES {
        spot.pace = pace * length(v);
        return spot;
    }
    if FOLLOWS_SHIFT {
        let momentum = law_momentum_at(x, v, spot.tau);
        let scale = real_exp(p[0].w) * ray_scale;
        spot.momentum = scale * momentum.xyz;
        spot.energy = scale * momentum.w;
        spot.turning = 0.0;
        spot.pace = pace / scale;
    } else {
        let momentum = law_momentum(x, v);
        let around = cross(frequency.axis, law_arm(x));
        let weight = 1.0 / max(dot(around, around), 1e-30);
        let known = Real2(momentum.w, dot(around, momentum.xyz));
        let weighed = Real2(known.x, weight * known.y);
        let scale = dot(weighed, ray_kept) / dot(weighed, known);
        spot.momentum = scale * momentum.xyz;
        spot.energy = ray_kept.x;
        spot.turning = ray_kept.y;
        spot.pace = pace / scale;
    }
    return spot;
}
