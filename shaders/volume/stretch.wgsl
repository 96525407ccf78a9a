// A step of any motion as a part of a path along which light is transferred.

struct Stretch {
    start: Phase,
    // The size, in the parameter of the step.
    h: Real,
    tau: Real,
    polynomial: StepPolynomial,
}

// The coefficients of the powers of s from -1 at the start of a step to 1 at its end, if it is interpolated.
struct StepPolynomial {
    middle: Phase,
    first: Phase,
    second: Phase,
    third: Phase,
    fourth: Phase,
    fifth: Phase,
}

fn stretch_of(ray: Ray, next: Ray) -> Stretch {
    return stretch_step(ray.phase, next.phase, own_size(ray, next), ray.tau);
}

fn stretch_last(step: LastStep) -> Stretch {
    return stretch_step(step.phase, step.end, step.h, step.tau);
}

fn stretch_place(step: Stretch, f: Real) -> Real3 {
    if WEAKENS_LINES {
        if on_line {
            return line_start + f * line_way;
        }
    }
    return stretch_phase(step, f)[0].xyz;
}

// Returns about the length of a step, which may return to its start, and the largest coordinates along it.
fn stretch_extent(step: Stretch, until: Real) -> Real2 {
    let start = step.start[0].xyz;
    let middle = stretch_place(step, 0.5 * until);
    let end = stretch_place(step, until);
    return Real2(distance(start, middle) + distance(middle, end), max(length(start), max(length(middle), length(end))));
}

// Returns the rest of a path to the horizon, as a fraction of the step at the rate here; it counts if it is positive.
fn stretch_left(step: Stretch, f: Real) -> Real {
    let p = stretch_phase(step, f);
    return 1.0 / (step.h * own_pace(p) * law_descent(p[0].xyz, path_velocity(p[1].xyz), transfer.horizon));
}

// Returns a point of a path in the scene, without the light there.
fn spot_at(x: Real3) -> Spot {
    var spot: Spot;
    spot.x = x;
    spot.higher = 1.0;
    spot.index = 1.0;
    if EMITS {
        let n = medium_index(x);
        spot.index = n * n;
    }
    if PLACES_BY_LAW {
        let q = formula_axes(law_arm(x));
        spot.r = law_radius(law_arm(x));
        spot.cosine = clamp(q.z / max(spot.r, 1e-30), -1.0, 1.0);
        spot.sine = length(q.xy) / max(law_axial(spot.r), 1e-30);
    }
    return spot;
}

// Returns a point of a straight line, with matter as it is at the camera's time.
fn line_spot(x: Real3) -> Spot {
    var spot = spot_at(x);
    spot.time = Real(transfer.time);
    spot.pace = length(line_way);
    spot.length = spot.pace;
    return spot;
}

// Returns the position and the light at a fraction of a step.
fn stretch_spot(step: Stretch, f: Real) -> Spot {
    if WEAKENS_LINES {
        if on_line {
            return line_spot(stretch_place(step, f));
        }
    }
    let p = stretch_phase(step, f);
    let x = p[0].xyz;
    let v = path_velocity(p[1].xyz);
    var spot = spot_at(x);
    if VOLUMES_CHANGE {
        spot.tau = step.tau + own_tau(step.start, p, f * step.h);
        spot.time = Real(transfer.time) - spot.tau;
    }
    let pace = own_pace(p) * step.h;
    spot.length = pace * length(v);
    if !SHIFTS_VOLUMES {
        spot.pace = spot.length;
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
