// How far samples are from each other is kept with those that say how many more a pixel takes.

fn keep_spread(pixel: vec2u, c: vec3f) {
}
