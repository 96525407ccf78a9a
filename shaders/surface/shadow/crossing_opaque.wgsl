// Nothing that light could meet lets it through.

fn crossing_share(shadows: u32, hit: ptr<function, Hit>, x: Real3, way: Real3) -> f32 {
    return 0.0;
}
