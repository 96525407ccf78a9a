// A law whose acceleration has no value that is constant along a ray.

fn law_ray_constant(p: Phase) -> Real {
    return 0.0;
}
