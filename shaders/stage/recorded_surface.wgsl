// Where a ray ended, and which object it hit.

struct Recorded {
    end: PathPoint,
    // 0 for none, else the object's place in the scene file, from 1.
    object: u32,
}

fn recorded_at(ray: Ray, pixel: vec2u) -> Recorded {
    let hit = load_hit(pixel);
    let end = path_end(ray, hit);
    if ray.status != HIT {
        return Recorded(end, 0u);
    }
    return Recorded(end, hit_surface(hit.primitive, end.x).object + 1u);
}
