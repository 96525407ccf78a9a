// What a ray saw at its end.

struct Seen {
    end: PathPoint,
    // What surfaces send back; black elsewhere.
    color: vec3f,
    normal: vec3f,
    // 0 for none, else the object's place in the scene file, from 1.
    object: u32,
}
