// No layers besides colour.

fn keep_layers(pixel: vec2u, ray: Ray, seen: Seen) {
}
