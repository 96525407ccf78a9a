// Where a ray ended, in a scene without surfaces.

struct Recorded {
    end: PathPoint,
    object: u32,
}

fn recorded_at(ray: Ray, pixel: vec2u) -> Recorded {
    return Recorded(path_end(ray, Hit(0.0, NOTHING)), 0u);
}
