// Maps the items of the acceleration structure to primitives. Items of a single kind are stored in the order of the structure; items of
// several kinds, or items that a grid has in many cells, are listed.

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
