// No sample is brighter than the scene says; what that takes from the picture is counted, pixel by pixel.

struct Brightest {
    // Of the brightest channel.
    radiance: f32,
}

@group(0) @binding(165) var<uniform> brightest: Brightest;
@group(0) @binding(166) var clamped_samples: texture_storage_2d<r32uint, read_write>;
// Radiance, all colours together.
@group(0) @binding(167) var clamped_light: texture_storage_2d<r32float, read_write>;

fn clamp_sample(pixel: vec2u, c: ptr<function, vec3f>) {
    let most = max((*c).x, max((*c).y, (*c).z));
    let left = min(brightest.radiance / max(most, 1e-30), 1.0);
    let taken = (1.0 - left) * ((*c).x + (*c).y + (*c).z) / 3.0;
    *c *= left;
    let begins = frame.sample == 0u;
    let samples = select(textureLoad(clamped_samples, pixel).x, 0u, begins) + select(0u, 1u, left < 1.0);
    let light = select(textureLoad(clamped_light, pixel).x, 0.0, begins) + taken;
    textureStore(clamped_samples, pixel, vec4u(samples));
    textureStore(clamped_light, pixel, vec4f(light));
}
