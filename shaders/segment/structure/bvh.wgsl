// A bounding volume hierarchy over curved arcs. Nodes are in depth-first order, each with the node to continue with when it is missed, so
// that the walk needs no stack and can be suspended anywhere.
//
// A segment is walked once, as its chord, however many pieces it has: all pieces are, at each fraction, within the segment's bulge of the
// chord, so that the chord meets the box grown by the bulge at each fraction where the arc meets the box.

fn structure_hit(s: Segment, pieces: u32, nearest: Hit) -> Hit {
    var hit = nearest;
    let sweep = segment_sweep(s);
    let count = arrayLength(&nodes);
    var node = select(count, walk_begin(), pieces > 0u);
    // In turns: every ray to its next leaf, then all of them through their items, because neighboring lanes run together.
    while node < count && walk_has_room() {
        let leaf = next_leaf(node, count, sweep, hit.t);
        node = leaf.next;
        walk_turn();
        hit = items_hit(s, pieces, leaf.span, leaf.first, leaf.count, hit);
        walk_turn();
    }
    walk_stop(node, node >= count);
    return hit;
}
