// Items of several kinds, or of one that a grid has in many cells.

@group(0) @binding(89) var<storage, read> items: array<u32>;

fn item_at(i: u32) -> u32 {
    return items[i];
}

fn item_count() -> u32 {
    return arrayLength(&items);
}
