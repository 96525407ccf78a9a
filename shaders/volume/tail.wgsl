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
        let passes = transfer_exp(transferred.depth[k]);
        let m = channel_matter(k);
        transferred.light[k] += passes * channel_emission(k) * tail_sum(here.emission[m], above.emission[m], left);
        transferred.depth[k] += channel_absorption(k) * tail_sum(here.absorption[m], above.absorption[m], left);
    }
}

// The lowest power of the height that has a sum.
const TAIL_POWER: Real = -0.95;

// Returns the sum to the horizon of a quantity, from its values here and at twice the height; `left` is the distance at the rate here.
fn tail_sum(here: Real, above: Real, left: Real) -> Real {
    if here <= 0.0 || above <= 0.0 {
        return 0.0;
    }
    let power = log_ratio(above, here) / 0.6931471805599453;
    transfer_invalid = transfer_invalid || power < TAIL_POWER;
    return here * left / (1.0 + max(power, TAIL_POWER));
}
