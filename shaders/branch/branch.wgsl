// Which of its two rays is followed at a surface that both reflects and transmits.

struct Branch {
    reflects: bool,
    // What the ray's weight is multiplied by.
    weight: f32,
    // It is followed no further.
    cut: bool,
}
