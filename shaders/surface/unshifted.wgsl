// Light comes as it was sent.

fn color_shift() -> f32 {
    return 1.0;
}
