// Paths end at a given tau (G95 limits the length of rays): the last step is shortened to it.

struct Limit {
    length: f32,
}

@group(0) @binding(56) var<uniform> limit: Limit;

fn limited_step(h: f32, tau: f32) -> f32 {
    return min(h, limit.length - tau);
}

// A last step of a rounding error's size would move nothing.
fn length_reached(tau: f32) -> bool {
    return limit.length - tau <= 2e-7 * limit.length;
}
