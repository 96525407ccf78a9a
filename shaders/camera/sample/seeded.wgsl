// Selects the pattern of a pixel's samples by the pixel's position in the whole image and the seed of path tracing, so that images with
// different seeds have independent errors.

fn pattern_seed(pixel: vec2u) -> u32 {
    return (pixel.x * 0x9e3779b1u) ^ (pixel.y * 0x85ebca77u) ^ (transport.seed * 0x2545f491u);
}
