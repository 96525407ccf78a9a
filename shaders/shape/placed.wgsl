// Common parts of all shapes except meshes: the placement, the interval of a line inside, and the surface at a point.

// A shape in object space (unit sphere, cube |x|, |y|, |z| ≤ 1, cylinder x² + z² ≤ 1, |y| ≤ 1, square |x|, |z| ≤ 1, disk x² + z² ≤ 1) and
// its placement.
//
// The data that every segment is tested against is separate, in uniform arrays of a length that is known at compile time: a CPU loads
// storage lane by lane, and that alone would cost more than the test.
struct Placed {
    // The center, for spheres only.
    center: Real3,
    // The radius of a sphere, or the radius of a disk's hole, in object space, 0 for none.
    radius: Real,
    // The rows of the affine map from the scene's space to object space.
    row_x: Real4,
    row_y: Real4,
    row_z: Real4,
    material: u32,
    object: u32,
}

// The affine map alone.
struct LocalSpace {
    row_x: Real4,
    row_y: Real4,
    row_z: Real4,
}

// In the file of each shape, hit_…(own, primitive, a, d) returns the fraction at which the piece from a along d meets it, or 2.

// The range in which the line along a piece is inside a closed convex shape, in fractions of the piece. It is never inside if `enters` is
// above `leaves`, or is not a number.
struct Interval {
    enters: Real,
    leaves: Real,
}

// A surface near a point.
struct Surface {
    // The signed distance of the point from it, to first order.
    signed_distance: Real,
    // The distance of the shape's center behind the tangent plane: `signed_distance` is a difference from that.
    depth: Real,
    // The geometric unit normal there, outward.
    normal: Real3,
    // The unit normal for shading.
    shading_normal: vec3f,
    uv: vec2f,
    material: u32,
    object: u32,
}

fn local_space(p: Placed) -> LocalSpace {
    return LocalSpace(p.row_x, p.row_y, p.row_z);
}

fn local_point(p: LocalSpace, x: Real3) -> Real3 {
    let h = Real4(x, 1.0);
    return Real3(dot(p.row_x, h), dot(p.row_y, h), dot(p.row_z, h));
}

fn local_vector(p: LocalSpace, v: Real3) -> Real3 {
    return Real3(dot(p.row_x.xyz, v), dot(p.row_y.xyz, v), dot(p.row_z.xyz, v));
}

// Converts a gradient from object space to the scene's space.
fn scene_gradient(p: LocalSpace, g: Real3) -> Real3 {
    return g.x * p.row_x.xyz + g.y * p.row_y.xyz + g.z * p.row_z.xyz;
}

// Returns the first end of an interval that is on the piece, or 2.
fn first_end(inside: Interval) -> Real {
    let t = select(inside.leaves, inside.enters, inside.enters >= -overlap());
    return select(2.0, t, inside.enters <= inside.leaves && t >= -overlap() && t <= 1.0 + OVERLAP);
}

// Returns the intersection of two intervals.
fn both_inside(p: Interval, q: Interval) -> Interval {
    return Interval(max(p.enters, q.enters), min(p.leaves, q.leaves));
}

// Returns the range in which the line from a along d is inside a ball of squared radius r2 around 0. inverse_dd is 1/|d|², equal for every
// ball. The distance of the nearest point is computed directly, because the difference b² − a c loses all digits far away.
fn ball_interval(a: Real3, d: Real3, inverse_dd: Real, r2: Real) -> Interval {
    let nearest = -dot(a, d) * inverse_dd;
    let miss = a + nearest * d;
    let inside = r2 - dot(miss, miss);
    let half = select(-1.0, sqrt(max(inside, 0.0) * inverse_dd), inside >= 0.0);
    return Interval(nearest - half, nearest + half);
}

// Returns the range in which a coordinate that is p at the start of the piece and moves by d along it is within ±1.
fn slab_interval(p: Real, d: Real) -> Interval {
    // A constant coordinate gets a slab that is entered at −∞ and left at +∞, or never.
    let inverse = 1.0 / select(d, 1e-30, d == 0.0);
    return Interval(-p * inverse - abs(inverse), abs(inverse) - p * inverse);
}

// Returns u around y, and v from the south to the north pole.
fn sphere_uv(p: Real3) -> vec2f {
    return vec2f(turn_round(p), f32(0.5 + arc_tangent(p.y, length(p.xz)) / PI));
}

// Returns the fraction of a turn around y, from −z over −x, z and x.
fn turn_round(p: Real3) -> f32 {
    return f32(0.5 + arc_tangent(p.x, p.z) / (2.0 * PI));
}

// Surfaces that reflect or transmit are met from the side that a ray is known to be on: from outside it enters, from inside it leaves. A
// ray that was just refracted or reflected is on the surface only up to rounding, but cannot meet it in the other direction. So it needs no
// offset, and rounding errors are corrected: a ray outside that is inside according to the set leaves at once, and a ray inside that moves
// further in enters.

// A convex shape in object space, and the object's bit in the set of regions.
struct SidedSpace {
    row_x: Real4,
    row_y: Real4,
    row_z: Real4,
    bit: u32,
}

fn sided_space(own: SidedSpace) -> LocalSpace {
    return LocalSpace(own.row_x, own.row_y, own.row_z);
}

fn is_inside(bit: u32) -> bool {
    return ((inside >> bit) & 1u) == 1u;
}

// Returns the fraction at which a piece crosses a convex surface, or 2. span: the range in which the line of the piece is inside it.
fn crossing(span: Interval, bit: u32) -> Real {
    let missed = span.enters > span.leaves;
    let leaves = select(max(span.leaves, 0.0), 0.0, missed);
    let ahead = !missed && span.leaves > 0.0 && span.enters + span.leaves > 0.0;
    let t = select(select(2.0, max(span.enters, 0.0), ahead), leaves, is_inside(bit));
    return select(2.0, t, t <= 1.0 + OVERLAP);
}
