// Scales the brightness of light by g⁴, integrated over all frequencies, where g is the redshift factor. The hue does not change, except
// for black bodies, whose color is known at any g. Optionally each color is taken as the one of a black body with the same ratio of red to
// blue: shifted by g it looks like a black body of g times the temperature.

// The range of temperatures, in kelvins, in which a color determines one.
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
