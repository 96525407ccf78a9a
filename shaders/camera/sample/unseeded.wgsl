// Selects the pattern of a pixel's samples by the pixel's position in the whole image, so that tiles and schedules do not show.

fn pattern_seed(pixel: vec2u) -> u32 {
    return (pixel.x * 0x9e3779b1u) ^ (pixel.y * 0x85ebca77u);
}
