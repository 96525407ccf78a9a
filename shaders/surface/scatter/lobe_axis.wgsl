// A ray that is traced goes along the axis of every lobe.

fn lobe_point(pixel: vec2u, index: u32) -> vec2f {
    return vec2f(0.0);
}
