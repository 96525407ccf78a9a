// The color of a surface as a function of position.

// A uniform color.

const CONSTANT: u32 = 0u;

fn pattern_constant(material: Material, uv: vec2f) -> vec3f {
    return material.color;
}

// Two alternating colors, averaged over the footprint of a sample if it is known: over a box with equal variance, which has a closed form.

const CHECKER: u32 = 1u;

fn pattern_checker(material: Material, uv: vec2f) -> vec3f {
    if KEEPS_FOOTPRINTS {
        let a = footprint[0].xy * material.repeat;
        let b = footprint[1].xy * material.repeat;
        let mean = alternating_mean(uv * material.repeat, sqrt(a * a + b * b));
        return mix(material.second_color, material.color, 0.5 + 0.5 * mean.x * mean.y);
    }
    let cell = floor(uv * material.repeat);
    let odd = fract(0.5 * (cell.x + cell.y)) > 0.25;
    return select(material.color, material.second_color, odd);
}

// Returns the integral of a function that alternates between 1 and -1.
fn alternating_sum(x: vec2f) -> vec2f {
    return 1.0 - 2.0 * abs(fract(0.5 * x) - 0.5);
}

// Returns its mean over a side around x. If the side contains at most one edge, only the distance of that edge counts.
fn alternating_mean(x: vec2f, side: vec2f) -> vec2f {
    let own = select(vec2f(1.0), vec2f(-1.0), fract(0.5 * floor(x)) > vec2f(0.25));
    let beside = min(2.0 * abs(x - round(x)), side) / max(side, vec2f(1e-30));
    let over = (alternating_sum(x + 0.5 * side) - alternating_sum(x - 0.5 * side)) / max(side, vec2f(1.0));
    return select(select(own * beside, own, side == vec2f(0.0)), over, side > vec2f(1.0));
}

// A repeated image.

const IMAGE: u32 = 2u;

fn pattern_image(material: Material, uv: vec2f) -> vec3f {
    if KEEPS_FOOTPRINTS {
        span_pattern(vec2f(1.0, -1.0) * material.repeat);
    }
    return image_sample(material.image, fract(vec2f(uv.x, 1.0 - uv.y) * material.repeat), true);
}
