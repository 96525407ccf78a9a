// Where light that a surface sends to the viewer has come from: a little off it, on the viewer's side.

// In parts of the numbers that its place was computed from: further than rounding moves it.
const OFF: Real = 8e-6;

fn lit_from(x: Real3, surface: Surface, view: vec3f) -> Real3 {
    let off = OFF * (length(x) + surface.depth);
    return x + select(-off, off, dot(vec3f(surface.across), view) >= 0.0) * surface.across;
}
