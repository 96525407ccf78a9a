// The radius of laws whose formulas of matter have the distance from the center as r.

// Returns the radius r of a position relative to the center, or to that of its mouth.
fn law_radius(arm: Real3) -> Real {
    return length(arm);
}

// Returns the distance from the axis at radius r on the equator.
fn law_axial(r: Real) -> Real {
    return r;
}
