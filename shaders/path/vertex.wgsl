// A vertex: a place where a path goes on in a direction that it chooses.

// What a surface makes of light there.
struct Answer {
    // Radiance of its own.
    emission: vec3f,
    // What it gives back evenly: its albedo, rho.
    diffuse: vec3f,
    // What it gives back about the mirror's direction, k, seen along the normal (Lafortune and Willems 1994), and the lobe's exponent e.
    gloss: vec3f,
    exponent: f32,
}

struct PathVertex {
    // A little off the surface, on the side that the path came from.
    x: Real3,
    tau: Real,
    // Of light there.
    speed: Real,
    // Unit vectors to that side: the surface's own normal, the one to shade with, and where a mirror would send the path.
    across: vec3f,
    normal: vec3f,
    mirror: vec3f,
    answer: Answer,
}

// Two unit vectors square to a third, which is the last column (Duff et al. 2017).
fn frame_about(n: vec3f) -> mat3x3f {
    let side = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (side + n.z);
    let b = n.x * n.y * a;
    return mat3x3f(vec3f(1.0 + side * n.x * n.x * a, side * b, -side * n.x), vec3f(b, side + n.y * n.y * a, -n.y), n);
}

// About an axis, at an angle of this cosine and sine, so many turns round.
fn way_about(axis: vec3f, cosine: f32, sine: f32, turns: f32) -> vec3f {
    let phi = 2.0 * f32(PI) * turns;
    return normalize(frame_about(axis) * vec3f(sine * cos(phi), sine * sin(phi), cosine));
}
