// A vortex: rays are driven round an axis, most at the distance `width` from it.

fn law_acceleration(x: Real3, held: Real) -> Real3 {
    let across = x - dot(x, Real3(0.0, 0.0, 1.0)) * Real3(0.0, 0.0, 1.0);
    return (0.75 * real_exp(-dot(across, across) / (0.75 * 0.75))) * cross(Real3(0.0, 0.0, 1.0), across);
}
