// What a screen shows of linear light, from 0 to 1: exposure, tone map and the sRGB curve (IEC 61966-2-1), as in the PNG.

fn displayed(c: vec3f) -> vec3f {
    let x = clamp(tonemapped(max(c, vec3f(0.0)) * refinement.gain), vec3f(0.0), vec3f(1.0));
    let bent = 1.055 * pow(max(x, vec3f(0.0031308)), vec3f(1.0 / 2.4)) - 0.055;
    return select(bent, 12.92 * x, x <= vec3f(0.0031308));
}
