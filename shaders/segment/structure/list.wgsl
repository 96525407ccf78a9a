// No acceleration structure: intersects every item with every piece of every segment, up to the limit of a pass (the crossbar of W04 §5.4).

fn structure_hit(s: Segment, pieces: u32, nearest: Hit) -> Hit {
    var hit = nearest;
    let count = item_count();
    var item = select(count, walk_begin(), pieces > 0u);
    while item < count && walk_has_room() {
        hit = items_hit(s, pieces, Span(0.0, 1.0), item, 1u, hit);
        item += 1u;
        walk_turn();
    }
    walk_stop(item, item >= count);
    return hit;
}
