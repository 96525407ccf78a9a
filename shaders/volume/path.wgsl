// The light of matter along a whole path, from pass to pass.

// Adds the light of a step up to the fraction `until`, as the camera sees it.
fn transfer_along(step: Stretch, until: Real) {
    if !IS_SPECTRAL {
        transfer_step(step, until);
        add_step();
    } else if COUNTS_TRANSFER {
        let before = transferred.light;
        transfer_step(step, until);
        let weight = select(0.0, Real(kept_throughput().x), glow_counts);
        for (var k = 0u; k < CHANNELS; k++) {
            transferred.light[k] = before[k] + weight * (transferred.light[k] - before[k]);
        }
    } else {
        transfer_step(step, until);
    }
}

// Prepares the transfer along the next steps of a pixel's ray.
fn begin_transfer(pixel: vec2u) {
    if SHIFTS_VOLUMES {
        note_kept(pixel);
    }
    load_transfer(pixel);
    transfer_invalid = false;
    transfer_unsettled = false;
    transfer_doubts = array<Real2, CHANNELS>();
}

// Adds the light of the step from `ray` to `next`, up to the fraction `until`.
fn transfer_passed(ray: Ray, next: Ray, until: Real) {
    if TRANSFERS_ORBITS {
        return;
    }
    if COUNTS_TRANSFER {
        note_glow();
    }
    transfer_along(stretch_of(ray, next), until);
}

// Adds the light of the last step of a path, up to its end.
fn transfer_end(pixel: vec2u, ray: Ray, end: PathPoint) {
    begin_transfer(pixel);
    if !TRANSFERS_ORBITS {
        var is_lit = end.fraction > 0.0;
        if HAS_HORIZON {
            is_lit = is_lit || ray.status == CAPTURED;
        }
        if is_lit {
            transfer_last(ray, end.fraction);
        }
    }
    keep_transfer(pixel);
}

// The least part of the last step of a captured path that is taken again.
const LEAST_LAST: Real = 1e-3;

// Adds the light of the last step up to the fraction `until`. A captured path's step is taken again up to there, or a little further,
// because the rest may be below the horizon.
fn transfer_last(ray: Ray, until: Real) {
    let last = last_step(ray);
    if HAS_HORIZON {
        if ray.status == CAPTURED {
            let part = max(until, LEAST_LAST);
            let h = part * last.h;
            let step = stretch_step(last.phase, retaken_step(last.phase, h), h, last.tau);
            if until > 0.0 {
                transfer_along(step, until / part);
            }
            transfer_tail(step, until / part);
            return;
        }
    }
    transfer_along(stretch_last(last), until);
}

// Adds the light of the last step, after a surface has put the ray into another region; `came_through` is the region that it passed.
fn transfer_left(pixel: vec2u, ray: Ray, end: PathPoint, came_through: u32) {
    let now = region_bits();
    enter_set(came_through);
    transfer_end(pixel, ray, end);
    enter_set(now);
}

// Adds the light of a segment between two slots of the state, if its ray continues after it.
fn transfer_segment(spot: ActiveRay, lives: bool) {
    if lives {
        load_throughput(spot.pixel);
        begin_transfer(spot.pixel);
        let ray = load_ray(spot.pixel, spot.word);
        transfer_passed(ray, accepted_step(ray), 1.0);
        keep_transfer(spot.pixel);
        store_throughput(spot.pixel);
    }
}

// Stores the light so far. Light that is not defined is lost, and so are the path's earlier pieces: the ray shows nothing.
fn keep_transfer(pixel: vec2u) {
    if IS_SPECTRAL {
        note_doubts();
    } else {
        if TRANSFERS_ORBITS {
            if COUNTS_TRANSFER {
                note_glow();
            }
        }
        add_step();
    }
    if transfer_unsettled {
        tally_at_once(UNSETTLED);
    }
    if transfer_invalid {
        fail_transfer();
    }
    store_transfer(pixel);
}
