// All space has one filter.

fn filter_place() -> u32 {
    return 0u;
}
