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
        let leaf = next_leaf(node, end, own_sweep, hit.t);
        node = leaf.next;
        walk_turn();
        if leaf.count != 0u && enters_instance(leaf.first) {
            node = enter_instance(leaf.first);
            end = instance_end();
            own = instance_segment(s);
            own_sweep = instance_sweep(s, own);
        } else {
            hit = items_hit(own, pieces, leaf.span, leaf.first, leaf.count, hit);
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
