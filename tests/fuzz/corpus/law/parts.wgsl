const LEAST: Real = 1e-3;
struct Both { a: Real3, b: Real }
fn own(x: Real3) -> Both {
    if length(x) < LEAST { return Both(x, 1.0); }
    return Both(-x, 0.0);
}
fn law_acceleration_by_velocity(x: Real3, v: Real3) -> Real3 {
    let both = own(x);
    return select(both.a, cross(x, v), both.b > 0.5);
}
fn law_scale(p: Phase) -> Real { return 1.0; }
fn law_start(x: Real3, v: Real3) -> Phase { return Phase(Real4(x, 0.0), Real4(v, 0.0)); }
