// Light is as bright as its shift makes it: by g⁴, over all of its frequencies together. Its hue stays, but for black bodies', of which the
// colour is known at any shift; or each colour is taken for that of the black body whose red and blue are as it has them: what is shifted
// by g looks like one of g times the temperature.

// Kelvins: between these a colour says how hot it is.
const REDDEST: f32 = 2000.0;
const BLUEST: f32 = 40000.0;
const HUE_HALVINGS: u32 = 12u;

fn hue_temperature(color: vec3f) -> f32 {
    var low = REDDEST;
    var high = BLUEST;
    for (var i = 0u; i < HUE_HALVINGS; i++) {
        let middle = sqrt(low * high);
        let body = black_body_row(middle).color;
        let redder = color.z * body.x < color.x * body.z;
        high = select(high, middle, redder);
        low = select(middle, low, redder);
    }
    return sqrt(low * high);
}

fn beamed(color: vec3f) -> vec3f {
    if SHIFTS_HUES {
        let kelvins = hue_temperature(color);
        return color * black_body_color(kelvins * color_shift(), kelvins) / black_body_color(kelvins, kelvins);
    }
    let g2 = color_shift() * color_shift();
    return (g2 * g2) * color;
}
