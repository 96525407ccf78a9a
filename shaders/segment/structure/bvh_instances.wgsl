// As bvh.wgsl, over meshes that are kept once. The nodes over all that the scene shows come first, behind them those of each mesh, in
// the mesh's own space. A leaf of the first that holds an instance leads into its mesh, and the walk goes on behind that leaf where the
// mesh's nodes end: there is no stack here either. A place of the walk is a node of the first, or behind them one of an instance's.

fn structure_hit(s: Segment, pieces: u32, nearest: Hit) -> Hit {
    var hit = nearest;
    let count = nodes[0].lo_skip.w;
    let sweep = segment_sweep(s);
    var own = s;
    var own_sweep = sweep;
    var end = count;
    var node = select(count, walk_begin(), pieces > 0u);
    leave_instance();
    if node > count {
        node = resume_instance(node - count - 1u);
        end = instance_end();
        own = instance_segment(s);
        own_sweep = instance_sweep(s, own);
    }
    while node < end && walk_has_room() {
        work += 1u;
        var span = Span(0.0, 0.0);
        var leaf = 0u;
        while node < end && leaf == 0u && walk_has_room() {
            work += 1u;
            let box = nodes[node];
            span = box_span(corner(box.lo_skip), corner(box.hi_leaf), own_sweep, hit.t);
            let met = span.enters <= span.leaves;
            leaf = select(0u, box.hi_leaf.w, met);
            node = select(box.lo_skip.w, node + 1u, met && box.hi_leaf.w == 0u);
        }
        walk_turn();
        let first = leaf & LEAF_FIRST;
        if leaf != 0u && enters_instance(first) {
            node = enter_instance(first);
            end = instance_end();
            own = instance_segment(s);
            own_sweep = instance_sweep(s, own);
        } else {
            hit = items_hit(own, pieces, span, first, leaf >> LEAF_SHIFT, hit);
            if node >= end && in_instance() {
                node = instance_next();
                leave_instance();
                end = count;
                own = s;
                own_sweep = sweep;
            }
        }
        walk_turn();
    }
    walk_stop(select(node, count + 1u + instance_place(node), in_instance()), node >= count && !in_instance());
    return hit;
}
