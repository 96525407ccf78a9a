// Reads the bundle of light of a pixel, which an earlier render has measured.

fn pixel_bundle(pixel: vec2u) -> Bundle {
    return Bundle(stored_end.across, stored_end.down, stored_end.shared_end);
}
