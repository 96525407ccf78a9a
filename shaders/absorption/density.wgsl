// The absorption coefficient of each kind, per unit length. In a texture it follows from the value of the noise.

// A uniform coefficient.

const EVEN: u32 = 0u;

fn density_even(absorption: Absorption, p: MatterPlace) -> vec3f {
    return absorption.color;
}

// A coefficient that the user wrote as formulas.

const FORMULA: u32 = 1u;

fn density_formula(absorption: Absorption, p: MatterPlace) -> vec3f {
    return absorption_formula(absorption.which, p);
}

// A color that the user wrote as formulas; values outside [0, 1] are invalid.

const COLOR_FORMULA: u32 = 2u;

fn density_color_formula(absorption: Absorption, p: MatterPlace) -> vec3f {
    let color = absorption_formula(absorption.which, p);
    return select(vec3f(-1.0), density_of(color), color >= vec3f(0.0) & color <= vec3f(1.0 + 1e-6));
}

// A transition between two colors.

const MIX: u32 = 3u;

fn density_mix(absorption: Absorption, p: MatterPlace, sum: f32) -> vec3f {
    return density_of(mix(absorption.color, absorption.high, texture_share(absorption, sum)));
}

// A transition between two colors, repeated several times (T 2.4.3).

const WRAPPED: u32 = 4u;

fn density_wrapped(absorption: Absorption, p: MatterPlace, sum: f32) -> vec3f {
    return density_of(mix(absorption.color, absorption.high, fract(absorption.times * texture_share(absorption, sum))));
}

// Seven colors, linear in between. The rainbow of T comes from an equation that T does not print; this one is different.

const RAINBOW: u32 = 5u;

fn density_rainbow(absorption: Absorption, p: MatterPlace, sum: f32) -> vec3f {
    var stops = array<vec3f, 7>(
        vec3f(0.95, 0.15, 0.15),
        vec3f(0.95, 0.55, 0.12),
        vec3f(0.95, 0.92, 0.15),
        vec3f(0.2, 0.85, 0.25),
        vec3f(0.15, 0.7, 0.95),
        vec3f(0.2, 0.25, 0.95),
        vec3f(0.65, 0.2, 0.9),
    );
    let at = 6.0 * texture_share(absorption, sum);
    let stop = min(u32(at), 5u);
    return density_of(mix(stops[stop], stops[stop + 1u], at - f32(stop)));
}

// The colors of the middle row of an image, from left to right.

const RAMP: u32 = 6u;

fn density_ramp(absorption: Absorption, p: MatterPlace, sum: f32) -> vec3f {
    return density_of(min(image_sample(absorption.which, vec2f(texture_share(absorption, sum), 0.5), false), vec3f(1.0)));
}

// The row of an image along an axis, in waves that noise disturbs (Suffern 2007): u = (1 + sin(y + a s))/2.

const MARBLE: u32 = 7u;

fn density_marble(absorption: Absorption, p: MatterPlace, sum: f32) -> vec3f {
    let along = absorption.frequency * dot(absorption.axis, vec3f(p.q));
    let share = 0.5 + 0.5 * sin(along + absorption.times * sum);
    return density_of(min(image_sample(absorption.which, vec2f(share, 0.5), false), vec3f(1.0)));
}
