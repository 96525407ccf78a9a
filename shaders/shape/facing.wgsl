// Selects the side from which a triangle of a reflecting or transparent object can be hit: the side that the ray is known to be on.

// The bit of each object in the set of regions, or NO_BIT.
var<storage, read> object_bits: array<u32>;

const NO_BIT: u32 = 32u;

// bit: the bit of the triangle's object. through: above 0 if a ray leaves through the triangle.
fn may_cross(bit: u32, through: Real) -> bool {
    if !HAS_SIDED_MESH {
        return true;
    }
    return bit == NO_BIT || is_inside(bit) == (through > 0.0);
}
