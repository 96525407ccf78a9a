// One step to where W = W₀ cos α + W₁ sin α passes its value on the sphere that the object is, outwards.

fn stride(p: Phase) -> Real {
    let c = circle_of(p);
    let q = here().radius / media[place].a;
    let edge = (q * q - 1.0) / (q * q + 1.0);
    let w0 = c.here.w;
    let w1 = c.onward.w;
    let side = sqrt(max(w0 * w0 + w1 * w1 - edge * edge, 0.0));
    let angle = arc_tangent(w1, w0) - arc_tangent(side, edge);
    return next_turn(angle, w1 >= 0.0 && w0 >= edge - LAST_PART);
}
