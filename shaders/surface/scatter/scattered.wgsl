// What becomes of a ray at a surface that it goes on from.

struct Scattered {
    v: Real3,
    // What its weight is multiplied by.
    weight: vec3f,
    // It is followed no further.
    cut: bool,
    // False where the surface is opaque: there it ends.
    continues: bool,
}

// Which of its two rays is followed where a surface both reflects and transmits.
struct Branch {
    reflects: bool,
    // What the ray's weight is multiplied by.
    weight: f32,
    // It is followed no further.
    cut: bool,
}
