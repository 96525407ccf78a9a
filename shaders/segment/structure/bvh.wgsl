// A bounding volume hierarchy over curved arcs: nodes in depth-first order, each with the node to go on with when it is missed, so
// that the walk needs no stack and may stop and go on anywhere.
//
// A segment is walked once, as its chord, however many pieces it has: all of them stay, at each fraction, within the segment's
// bulge of the chord, so that a box grown by the bulge is met by the chord, at that fraction, where the box is met by the arc.

fn structure_hit(s: Segment, pieces: u32, nearest: Hit) -> Hit {
    var hit = nearest;
    let sweep = segment_sweep(s);
    let count = arrayLength(&nodes);
    var node = select(count, walk_begin(), pieces > 0u);
    // In turns: every ray to its next leaf, then all of them through their items, for neighbours run side by side.
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
