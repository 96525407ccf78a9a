// Two colours in turn.

const CHECKER: u32 = 1u;

fn pattern_checker(material: Material, uv: vec2f) -> vec3f {
    let cell = floor(uv * material.repeat);
    let odd = fract(0.5 * (cell.x + cell.y)) > 0.25;
    return select(material.color, material.second_color, odd);
}
