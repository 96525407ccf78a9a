// The result of scattering at a surface that reflects or transmits.

struct Scattered {
    v: Real3,
    // The factor of the ray's throughput.
    throughput: vec3f,
    // The ray is followed no further.
    cut: bool,
    // False if the surface is opaque: the ray ends there.
    continues: bool,
}

// The ray that is followed if a surface both reflects and transmits.
struct Branch {
    reflects: bool,
    // The factor of the ray's throughput.
    throughput: f32,
    // The ray is followed no further.
    cut: bool,
}
