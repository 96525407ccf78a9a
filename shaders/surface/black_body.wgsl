// The colours of black bodies, from a table: rows are even in the logarithm of the temperature.

struct BlackBody {
    // In linear sRGB of luminance 1.
    color: vec3f,
    // The logarithm of its own.
    luminance: f32,
}

var<storage, read> black_bodies: array<BlackBody>;

// Kelvins, of the first row and the last.
const COOLEST: f32 = 500.0;
const HOTTEST: f32 = 1e6;
const TEMPERATURES: u32 = 512u;

// At so many kelvins, in the luminance of one at `unit` of them. Above the hottest all look alike, and are as bright as they are hot.
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

// By how much light has shifted that is seen.
fn color_shift() -> f32 {
    if !BEAMS {
        return 1.0;
    }
    return f32(seen_shift);
}
