// Narkowicz's fit of the ACES film curve (2015), as in the PNG.

fn tonemapped(x: vec3f) -> vec3f {
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}
