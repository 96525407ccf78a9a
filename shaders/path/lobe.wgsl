// A lobe's direction from a path's own points.

const LOBE: u32 = 8u;

fn lobe_point(pixel: vec2u, index: u32) -> vec2f {
    return path_point(pixel, LOBE);
}
