// An index that is no finite number above 0 is made infinite, and its pull with it: the ray's state is then not finite, and the
// ray has failed. Nothing goes on with an index that does not exist.

fn limited_index(n: Real) -> Real {
    return select(infinite(), n, n > 0.0 && finite(Real3(n)));
}

// ∇(n²/2), of ∇n and n.
fn limited_pull(n: Real4) -> Real3 {
    let there = n.w > 0.0 && finite(Real3(n.w)) && finite(n.xyz);
    return select(Real3(infinite()), n.w * n.xyz, there);
}
