// The light between the end of a captured ray and the horizon.

// Adds the light of matter between the end of a captured ray and the horizon. There light and absorption grow or fall as powers of the
// height above it, because frequencies do.
fn transfer_tail(step: Stretch, until: Real) {
    let place = region_place(step, until);
    var within = 0u;
    for (var v = 0u; v < VOLUMES; v++) {
        within |= select(0u, 1u << v, place.gaps[v] < 0.0);
    }
    var spot = stretch_spot(step, until);
    let left = stretch_left(step, until);
    if within == 0u || !(left > 0.0 && left < 1e30) {
        return;
    }
    let here = matter_of(spot, within);
    spot.higher = 0.7071067811865476;
    let above = matter_of(spot, within);
    for (var k = 0u; k < CHANNELS; k++) {
        let m = channel_matter(k);
        let bright = tail_power(channel_emission(k) * left * here.emission[m], here.emission[m], above.emission[m]);
        let dim = tail_power(channel_absorption(k) * left * here.absorption[m], here.absorption[m], above.absorption[m]);
        var rest = tail_closed(bright, dim);
        if dim.x > 0.0 && dim.y < TAIL_POWER {
            rest = tail_opaque(bright, dim);
        }
        transferred.light[k] += transfer_exp(transferred.depth[k]) * rest.x;
        transferred.depth[k] += rest.y;
    }
}

// The lowest power of the height that has a sum.
const TAIL_POWER: Real = -0.95;
// Matter whose absorption has no sum is opaque. It is divided at halves of the height, and each part has a uniform source function.
const TAIL_HALVES: u32 = 60u;
const LN_2: Real = 0.6931471805599453;

// Returns a quantity times the distance to the horizon at the rate here, and its power of the height, from its values here and at twice the
// height.
fn tail_power(size: Real, here: Real, above: Real) -> Real2 {
    if here <= 0.0 || above <= 0.0 {
        return Real2(0.0);
    }
    return Real2(size, log_ratio(above, here) / LN_2);
}

// Returns the light and the optical depth down to the horizon, if the absorption has a sum.
fn tail_closed(bright: Real2, dim: Real2) -> Real2 {
    transfer_invalid = transfer_invalid || (bright.y < TAIL_POWER && !(dim.y < TAIL_POWER));
    let depth = dim.x / (1.0 + max(dim.y, TAIL_POWER));
    return Real2(bright.x / (1.0 + max(bright.y, TAIL_POWER)) * uniform_share(depth), depth);
}

// Returns the light of matter that is opaque before the horizon, and its optical depth.
fn tail_opaque(bright: Real2, dim: Real2) -> Real2 {
    var light: Real = 0.0;
    var depth: Real = 0.0;
    var more = tail_half(bright);
    var darker = tail_half(dim);
    var i = 0u;
    loop {
        light += transfer_exp(depth) * more.x * uniform_share(darker.x);
        depth += darker.x;
        more.x *= more.y;
        darker.x *= darker.y;
        i += 1u;
        continuing {
            break if i == TAIL_HALVES || depth > OPAQUE;
        }
    }
    // The light of the rest, whose parts form a geometric series: the depth may grow as slowly as the logarithm of the height.
    let ratio = more.y * transfer_exp(darker.x);
    light += transfer_exp(depth) * more.x * uniform_share(darker.x) / max(1.0 - ratio, 1e-30);
    transfer_invalid = transfer_invalid || (depth < OPAQUE && ratio >= 1.0);
    return Real2(light, depth);
}

// Returns the sum of a quantity down to half of the height, and its ratio to that of the next half.
fn tail_half(quantity: Real2) -> Real2 {
    let power = 1.0 + quantity.y;
    let ratio = real_exp(-LN_2 * power);
    return Real2(quantity.x * select((1.0 - ratio) / power, LN_2, abs(power) < 1e-3), ratio);
}

// Returns the part of uniform light that passes its own matter.
fn uniform_share(depth: Real) -> Real {
    return select((1.0 - transfer_exp(depth)) / depth, 1.0 - 0.5 * depth, depth < 1e-3);
}
