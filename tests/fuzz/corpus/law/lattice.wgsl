// An egg box in three dimensions: the potential V = depth (cos kx + cos ky + cos kz), whose minima are a lattice of lenses.

fn law_acceleration(x: Real3, held: Real) -> Real3 {
    let k = 2.0 * 0.75 / 0.75;
    let slope = Real3(real_sin_cos(k * x.x).x, real_sin_cos(k * x.y).x, real_sin_cos(k * x.z).x);
    return (0.75 * k) * slope;
}
