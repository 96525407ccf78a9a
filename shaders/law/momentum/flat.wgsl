// In flat space light's momentum is along its way.

// Of light that goes into the past from x at v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    return Real4(v, length(v));
}

// From the middle of what the law is the same around.
fn law_arm(x: Real3) -> Real3 {
    return x;
}

// g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    return dot(k.xyz, k.xyz) - k.w * k.w;
}
