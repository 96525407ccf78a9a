// Maps the items of a hierarchy over mesh instances to primitives: the items of the scene are listed, and those of a mesh are its
// triangles, in the order of the mesh, each as a primitive of the instance that the walk is in.

var<storage, read> items: array<u32>;

const NO_INSTANCE: u32 = 0xffffffffu;

// The instance that the walk is in, and the offset from its triangles to primitives.
var<private> instance: u32;
var<private> instance_shift: u32;

fn in_instance() -> bool {
    return instance != NO_INSTANCE;
}

fn item_at(i: u32) -> u32 {
    if in_instance() {
        return INSTANCE | (i + instance_shift);
    }
    return items[i];
}

// Returns `true` if a leaf holds an instance: then it holds nothing else.
fn enters_instance(first: u32) -> bool {
    return !in_instance() && items[first] >= INSTANCE;
}

fn leave_instance() {
    instance = NO_INSTANCE;
}

// Enters an instance, and returns the first node of its mesh.
fn enter_instance(first: u32) -> u32 {
    begin_instance(items[first] & INSTANCE_INDEX);
    return instances[instance].root;
}

// Resumes a walk at a position among the nodes of all instances, and returns the node.
fn resume_instance(place: u32) -> u32 {
    begin_instance(instance_of(place, true));
    return instances[instance].root + place - instances[instance].places;
}

fn begin_instance(i: u32) {
    instance = i;
    instance_shift = instances[i].primitives - instances[i].first;
}

// Returns the end of the nodes of the instance's mesh.
fn instance_end() -> u32 {
    return nodes[instances[instance].root].lo_skip.w;
}

// Returns the node after the leaf that led into the instance.
fn instance_next() -> u32 {
    return instances[instance].next;
}

fn instance_place(node: u32) -> u32 {
    let own = instances[select(0u, instance, in_instance())];
    return own.places + node - own.root;
}

// Transforms a segment to the space of the mesh. A cubic stays a cubic under an affine map.
fn instance_segment(s: Segment) -> Segment {
    let space = instance_space(instance);
    return Segment(
        local_point(space, s.x0),
        local_vector(space, s.v0),
        local_point(space, s.x1),
        local_vector(space, s.v1),
        s.h,
    );
}

// own: the segment in the space of the mesh, whose rounding error is the one of all terms of its sums.
fn instance_sweep(s: Segment, own: Segment) -> Sweep {
    let space = instance_space(instance);
    let most = Real4(max(abs(s.x0), abs(s.x1)), 1.0);
    let sums = Real3(dot(abs(space.row_x), most), dot(abs(space.row_y), most), dot(abs(space.row_z), most));
    return sweep_within(own, BOX_SLACK * sums);
}

// Returns the fraction of the piece from a along d, both in the space of the mesh, or 2.
fn instance_fraction(i: u32, a: Real3, d: Real3) -> Real {
    let meeting = meet_triangle(i - instance_shift, a, d);
    let met = may_cross(instances[instance].object, meeting.through) && !is_last_hit(INSTANCE | i);
    return select(2.0, meeting.t, met);
}
