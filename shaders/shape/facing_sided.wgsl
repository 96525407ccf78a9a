// Triangles of objects that rays go on from are met from the side that a ray is known to be on.

// through: above 0 where a ray leaves through the triangle.
fn may_cross(object: u32, through: Real) -> bool {
    let bit = object_bits[object];
    return bit == NO_BIT || is_inside(bit) == (through > 0.0);
}
