// Clamps the brightness of samples to the scene's limit; the light that this removes from the image is recorded for every pixel.

struct Brightest {
    // The limit of the brightest channel.
    radiance: f32,
}

var<uniform> brightest: Brightest;
var<storage, read_write> pixel_clamped_samples: array<u32>;
// The radiance removed, summed over the colors.
var<storage, read_write> pixel_clamped_light: array<f32>;

fn clamp_sample(pixel: vec2u, c: ptr<function, vec3f>) {
    let most = max((*c).x, max((*c).y, (*c).z));
    let left = min(brightest.radiance / max(most, 1e-30), 1.0);
    let taken = (1.0 - left) * ((*c).x + (*c).y + (*c).z) / 3.0;
    *c *= left;
    let begins = frame.sample == 0u;
    let place = place_in_tile(pixel);
    pixel_clamped_samples[place] = select(pixel_clamped_samples[place], 0u, begins) + select(0u, 1u, left < 1.0);
    pixel_clamped_light[place] = select(pixel_clamped_light[place], 0.0, begins) + taken;
}
