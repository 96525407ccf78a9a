// From which side triangles are met: those of objects that rays go on from, from the side that a ray is known to be on.

// For each object its bit in the set of regions, or NO_BIT.
var<storage, read> object_bits: array<u32>;

const NO_BIT: u32 = 32u;

// bit: that of the triangle's object. through: above 0 where a ray leaves through the triangle.
fn may_cross(bit: u32, through: Real) -> bool {
    if !HAS_SIDED_MESH {
        return true;
    }
    return bit == NO_BIT || is_inside(bit) == (through > 0.0);
}
