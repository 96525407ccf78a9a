// What a weight is worth at its end, and when it is worth nothing.

// A path whose weight has fallen this low adds nothing that a float of the picture could show.
const DARK: f32 = 1e-8;

// Where a path began or ended in the middle of an infinite index its light is none.
fn sure_weight(weight: vec3f) -> vec3f {
    return select(vec3f(0.0), weight, finite(Real3(weight)));
}
