// Each region has a filter of its own, and the space outside of all the last one.

fn filter_place() -> u32 {
    return min(medium_object(), REGION_COUNT);
}
