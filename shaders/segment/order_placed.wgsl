// Items of a hierarchy over meshes that are kept once: those of the scene are listed, and those of a mesh are its triangles, in their
// own order, each as a primitive of the instance that the walk is in.

var<storage, read> items: array<u32>;

const NO_INSTANCE: u32 = 0xffffffffu;

// The instance that the walk is in, and from its triangles' places to those of primitives.
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

// A leaf that holds an instance holds nothing else.
fn enters_instance(first: u32) -> bool {
    return !in_instance() && items[first] >= INSTANCE;
}

fn leave_instance() {
    instance = NO_INSTANCE;
}

// Returns the first node of its mesh.
fn enter_instance(first: u32) -> u32 {
    begin_instance(items[first] & INSTANCE_INDEX);
    return instances[instance].root;
}

// A walk goes on at this place among those of all instances. Returns the node.
fn resume_instance(place: u32) -> u32 {
    begin_instance(instance_of(place, true));
    return instances[instance].root + place - instances[instance].places;
}

fn begin_instance(i: u32) {
    instance = i;
    instance_shift = instances[i].primitives - instances[i].first;
}

// Where the nodes of its mesh end.
fn instance_end() -> u32 {
    return nodes[instances[instance].root].lo_skip.w;
}

// The node behind the leaf that led into it.
fn instance_next() -> u32 {
    return instances[instance].next;
}

fn instance_place(node: u32) -> u32 {
    let own = instances[select(0u, instance, in_instance())];
    return own.places + node - own.root;
}

// In the mesh's own space. A cubic stays one in any affine map.
fn instance_segment(s: Segment) -> Segment {
    let space = instance_space(instance);
    return Segment(
        own_point(space, s.x0),
        own_vector(space, s.v0),
        own_point(space, s.x1),
        own_vector(space, s.v1),
        s.h,
    );
}

// own: the segment in the mesh's space, whose rounding is that of all numbers that it is the sum of.
fn instance_sweep(s: Segment, own: Segment) -> Sweep {
    let space = instance_space(instance);
    let most = Real4(max(abs(s.x0), abs(s.x1)), 1.0);
    let sums = Real3(dot(abs(space.row_x), most), dot(abs(space.row_y), most), dot(abs(space.row_z), most));
    return sweep_within(own, BOX_SLACK * sums);
}

// The fraction of the piece from a along d, both in the mesh's space, or 2.
fn instance_fraction(i: u32, a: Real3, d: Real3) -> Real {
    let meeting = meet_triangle(i - instance_shift, a, d);
    let met = may_cross(instances[instance].object, meeting.through) && !is_last_hit(INSTANCE | i);
    return select(2.0, meeting.t, met);
}
