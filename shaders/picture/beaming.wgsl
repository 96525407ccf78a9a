// Light is as bright as its shift makes it: by g⁴, over all of its frequencies together. Its hue stays, but for black bodies', of which the
// colour is known at any shift.

fn color_shift() -> f32 {
    return f32(seen_shift);
}

fn beamed(color: vec3f) -> vec3f {
    let g2 = color_shift() * color_shift();
    return (g2 * g2) * color;
}

fn beam_sky(color: ptr<function, vec3f>) {
    *color = beamed(*color);
}
