// A vortex: rays are driven around an axis, most at the distance `width` from it.

fn law_acceleration(x: Real3, held: Real) -> Real3 {
    let across = x - dot(x, law.axis) * law.axis;
    return (law.strength * real_exp(-dot(across, across) / (law.width * law.width))) * cross(law.axis, across);
}
