// Scatters rays at surfaces that reflect or transmit (in the schedules with a pass for each stage): each becomes active again, in the slot
// where the end of its segment would have been.

@compute @workgroup_size(GROUP)
fn scatter(own: Invocation) {
    let spot = active_ray(own);
    if spot.valid && may_scatter(spot.code) {
        load_throughput(spot.pixel);
        if AIMS {
            load_waiting(spot.pixel);
        }
        load_branches(spot.pixel);
        var met = load_hit(spot.pixel);
        let next = scatter_ray(load_ray(spot.pixel, spot.word), &met, spot.pixel);
        store_throughput(spot.pixel);
        if AIMS {
            store_waiting(spot.pixel);
        }
        store_branches(spot.pixel);
        if next.status == ALIVE {
            store_ray(spot.pixel, next);
            store_region(spot.pixel);
            store_last_hit(spot.pixel, next.index);
            store_status(spot.pixel, status_word(ALIVE, dispatch.end, next.index));
        } else {
            store_hit(spot.pixel, met);
            store_status(spot.pixel, status_word(next.status, status_slot(spot.word), next.index));
        }
    }
}
