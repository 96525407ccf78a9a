// A bounding volume hierarchy as in bvh.wgsl, over mesh instances. The nodes of the scene come first, then the nodes of each mesh, in the
// mesh's space. A scene leaf that holds an instance leads into its mesh, and the walk continues after that leaf at the end of the mesh's
// nodes: there is no stack here either. A position of the walk is a scene node, or, in the numbers after them, a node of an instance.

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
