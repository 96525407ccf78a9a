// Stores the bundle of light of each pixel for the samples after the grid.

var<storage, read_write> pixel_bundles: array<Bundle>;

fn pixel_bundle(pixel: vec2u) -> Bundle {
    return pixel_bundles[place_in_tile(pixel)];
}
