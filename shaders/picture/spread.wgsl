// Accumulates the squared distances of a pixel's samples from their mean, by luminance (Welford 1962). The host computes the standard error
// of the image from them.

var<storage, read_write> pixel_spread: array<f32>;

// Returns the luminance of linear light in the sRGB primaries.
fn luminance(c: vec3f) -> f32 {
    return dot(c, vec3f(0.2126, 0.7152, 0.0722));
}

// c: one more sample, which is not in the image yet.
fn keep_spread(pixel: vec2u, c: vec3f) {
    let n = f32(frame.sample);
    let sum = luminance(load_color(pixel));
    let own = luminance(c);
    let more = (own - sum / max(n, 1.0)) * (own - (sum + own) / (n + 1.0));
    let place = place_in_tile(pixel);
    pixel_spread[place] = select(pixel_spread[place] + more, 0.0, frame.sample == 0u);
}
