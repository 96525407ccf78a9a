// A law whose acceleration holds nothing constant along a ray.

fn law_held(p: Phase) -> Real {
    return 0.0;
}
