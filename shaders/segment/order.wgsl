// The structure's items. Those of a single kind lie in memory in the structure's own order; those of several kinds, or of one that a grid
// has in many cells, are listed.

var<storage, read> items: array<u32>;

fn item_at(i: u32) -> u32 {
    if ITEMS_IN_ORDER {
        return ITEM_KIND | i;
    }
    return items[i];
}

fn item_count() -> u32 {
    return arrayLength(&items);
}
