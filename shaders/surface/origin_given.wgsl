// Given rays each start inside of other meshes.

// For each ray the meshes that it starts in, as bits of the set of regions.
@group(0) @binding(135) var<storage, read> given_sets: array<u32>;

fn starts_inside(region_bit: u32, pixel: vec2u) -> bool {
    let index = pixel.y * frame.image.x + pixel.x;
    return ((given_sets[min(index, arrayLength(&given_sets) - 1u)] >> region_bit) & 1u) == 1u;
}
