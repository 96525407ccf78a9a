// The throat of James, von Tunzelmann, Franklin and Thorne (2015), eq. 5: r = ρ₀ for |l| ≤ a, and beyond that it opens like the paths of
// light around a black hole of mass M: r = ρ₀ + M (y atan y − ½ ln(1 + y²)) with y = 2(|l| − a)/πM.

// Returns r and dr/dl.
fn throat_radius(l: Real) -> Real2 {
    let y = max(2.0 * (abs(l) - law.half_length) / (PI * law.mouth), 0.0);
    let angle = arc_tangent(y, 1.0);
    let r = law.radius + law.mouth * (y * angle - 0.5 * real_log(1.0 + y * y));
    return Real2(r, select(Real(-1.0), 1.0, l >= 0.0) * (2.0 / PI) * angle);
}
