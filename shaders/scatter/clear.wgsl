// The surface of an object that light goes through: between the medium on this side and that on the other, which may be the same
// where a medium of higher priority is on both.

const CLEAR: u32 = 3u;

fn scatter_clear(material: Material, surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let bits = inside;
    let near_medium = medium_object();
    let n1 = medium_index(end.x);
    enter_set(set_beyond(1u << material.bit, surface, end.x));
    let n2 = medium_index(end.x);
    if medium_object() == near_medium {
        return Scattered(end.v, vec3f(1.0), false, true);
    }
    let both = refraction(n1 * normalize(end.v), surface.across, n1, n2);
    var taken = Branch(both.reflectance > 0.5, 1.0, false);
    if both.reflectance > 0.0 && both.reflectance < 1.0 {
        taken = chosen_branch(pixel, index, f32(both.reflectance));
    }
    if taken.reflects {
        enter_set(bits);
    }
    return Scattered(select(both.transmitted, both.reflected, taken.reflects), vec3f(taken.weight), taken.cut, true);
}
