// The colors of black bodies, from a table whose rows are uniform in the logarithm of the temperature.

struct BlackBody {
    // The color in linear sRGB, with luminance 1.
    color: vec3f,
    // The logarithm of the black body's luminance.
    luminance: f32,
}

var<storage, read> black_bodies: array<BlackBody>;

// The temperatures, in kelvins, of the first and the last row.
const COOLEST: f32 = 500.0;
const HOTTEST: f32 = 1e6;
const TEMPERATURES: u32 = 512u;

// Returns the color at a temperature in kelvins, in units of the luminance at the temperature `unit`. Above the hottest row the color is
// constant, and the luminance is proportional to the temperature.
fn black_body_color(kelvins: f32, unit: f32) -> vec3f {
    let here = black_body_row(kelvins);
    let hotter = max(kelvins / HOTTEST, 1.0);
    let luminance = f32(real_exp(Real(here.luminance - black_body_row(unit).luminance))) * hotter / max(unit / HOTTEST, 1.0);
    return select(vec3f(0.0), luminance * here.color, kelvins > COOLEST);
}

fn black_body_row(kelvins: f32) -> BlackBody {
    let last = f32(TEMPERATURES - 1u);
    let rate = last / f32(real_log(Real(HOTTEST / COOLEST)));
    let place = clamp(f32(real_log(Real(max(kelvins, COOLEST) / COOLEST))) * rate, 0.0, last);
    let first = min(u32(place), TEMPERATURES - 2u);
    let a = black_bodies[first];
    let b = black_bodies[first + 1u];
    let part = place - f32(first);
    return BlackBody(mix(a.color, b.color, part), mix(a.luminance, b.luminance, part));
}

// Returns the redshift factor of the light that is seen.
fn color_shift() -> f32 {
    if !BEAMS {
        return 1.0;
    }
    return f32(seen_shift);
}
