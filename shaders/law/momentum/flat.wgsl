// The momentum of light in flat space: it points along the direction of the light.

// Returns the momentum of light that leaves x into the past with velocity v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    return Real4(v, length(v));
}

// Returns the position of x relative to the center of symmetry of the law.
fn law_arm(x: Real3) -> Real3 {
    return x;
}

// Returns g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    return dot(k.xyz, k.xyz) - k.w * k.w;
}

// Returns the four-velocity of the Eulerian observer.
fn law_eulerian(x: Real3) -> Real4 {
    return Real4(0.0, 0.0, 0.0, 1.0);
}
