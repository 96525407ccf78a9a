// The throat of the Ellis wormhole: r² = ρ₀² + l².

// Returns r and dr/dl.
fn throat_radius(l: Real) -> Real2 {
    let r = sqrt(law.radius * law.radius + l * l);
    return Real2(r, l / r);
}
