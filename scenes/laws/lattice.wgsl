// An egg box in three dimensions: the potential V = depth (cos kx + cos ky + cos kz), whose minima are a lattice of lenses.

fn law_acceleration(x: Real3, held: Real) -> Real3 {
    let k = 2.0 * law.half_turn / law.spacing;
    let slope = Real3(real_sin_cos(k * x.x).x, real_sin_cos(k * x.y).x, real_sin_cos(k * x.z).x);
    return (law.depth * k) * slope;
}
