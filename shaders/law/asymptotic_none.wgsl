// The law ends at the bounding sphere.

fn departed(code: u32, x: Real3, v: Real3) -> mat2x3<Real> {
    return mat2x3<Real>(x, v);
}
