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
