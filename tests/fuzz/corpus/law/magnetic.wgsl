// Light that carries a charge, in a magnetic field along an axis: dv = q v x B, which turns v and keeps its size. The field falls
// off with the distance from the axis.

fn field(x: Real3) -> Real3 {
    let across = x - dot(x, Real3(0.0, 0.0, 1.0)) * Real3(0.0, 0.0, 1.0);
    return (0.75 * real_exp(-dot(across, across) / (0.75 * 0.75))) * Real3(0.0, 0.0, 1.0);
}

fn law_acceleration_by_velocity(x: Real3, v: Real3) -> Real3 {
    return cross(v, field(x));
}
