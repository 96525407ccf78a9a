// Makes an index infinite, with its pull, if it is not a finite number above 0: the state of the ray is then not finite, and the ray has
// failed. No ray continues with an invalid index.

fn limited_index(n: Real) -> Real {
    return select(infinite(), n, n > 0.0 && finite(Real3(n)));
}

// Returns ∇(n²/2), from ∇n and n.
fn limited_pull(n: Real4) -> Real3 {
    let there = n.w > 0.0 && finite(Real3(n.w)) && finite(n.xyz);
    return select(Real3(infinite()), n.w * n.xyz, there);
}
