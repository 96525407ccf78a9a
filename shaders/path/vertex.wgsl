// A vertex of a path: a position where the path continues in a direction that it chooses.

// The reflection and emission of a surface at the vertex.
struct Bsdf {
    // The emitted radiance.
    emission: vec3f,
    // The diffuse albedo, rho.
    diffuse: vec3f,
    // The glossy reflectance about the mirror direction, k, seen along the normal (Lafortune and Willems 1994), and the exponent e of the
    // lobe.
    gloss: vec3f,
    exponent: f32,
}

struct PathVertex {
    // The position, slightly off the surface, on the side that the path came from.
    x: Real3,
    tau: Real,
    // The speed of light there.
    speed: Real,
    // Unit vectors on that side: the geometric normal, the shading normal, and the mirror direction.
    normal: vec3f,
    shading_normal: vec3f,
    mirror: vec3f,
    bsdf: Bsdf,
}
