// Items of a single kind, which lie in memory in the structure's own order.

fn item_at(i: u32) -> u32 {
    return ITEM_KIND | i;
}
