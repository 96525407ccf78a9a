// How far a pixel's samples are from their mean: the sum of the squared distances, of their luminance (Welford 1962), from which the
// host has the standard error of the picture.

var<storage, read_write> pixel_spread: array<f32>;

// Of linear light in sRGB's primaries.
fn luminance(c: vec3f) -> f32 {
    return dot(c, vec3f(0.2126, 0.7152, 0.0722));
}

// c: one more sample, which is not in the picture yet.
fn keep_spread(pixel: vec2u, c: vec3f) {
    let n = f32(frame.sample);
    let sum = luminance(load_color(pixel));
    let own = luminance(c);
    let more = (own - sum / max(n, 1.0)) * (own - (sum + own) / (n + 1.0));
    let place = place_in_tile(pixel);
    pixel_spread[place] = select(pixel_spread[place] + more, 0.0, frame.sample == 0u);
}
