// A state's velocity is that of its place.

fn path_velocity(v: Real3) -> Real3 {
    return v;
}
