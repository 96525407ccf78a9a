// Light is as bright and as coloured as its shift makes it, each colour taken for that of the black body whose red and blue are as it has
// them: what is shifted by g looks like one of g times the temperature.

fn color_shift() -> f32 {
    return f32(seen_shift);
}

// Kelvins: between these a colour says how hot it is.
const REDDEST: f32 = 2000.0;
const BLUEST: f32 = 40000.0;
const HALVINGS: u32 = 12u;

fn hue_temperature(color: vec3f) -> f32 {
    var low = REDDEST;
    var high = BLUEST;
    for (var i = 0u; i < HALVINGS; i++) {
        let middle = sqrt(low * high);
        let body = black_body_row(middle).color;
        let redder = color.z * body.x < color.x * body.z;
        high = select(high, middle, redder);
        low = select(middle, low, redder);
    }
    return sqrt(low * high);
}

fn beamed(color: vec3f) -> vec3f {
    let kelvins = hue_temperature(color);
    return color * black_body_color(kelvins * color_shift(), kelvins) / black_body_color(kelvins, kelvins);
}

fn beam_sky(color: ptr<function, vec3f>) {
    *color = beamed(*color);
}
