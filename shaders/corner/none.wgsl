// Nothing is asked of corners.

fn keep_corner(pixel: vec2u, ray: Ray, seen: Seen) {
}
