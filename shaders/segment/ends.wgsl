// The end of a path: its last step, the place, what was seen there, and what is recorded.

// The last step of a path's last segment.
struct LastStep {
    phase: Phase,
    tau: Real,
    // Its size, in the measure that retaken_step takes.
    h: Real,
    end: Phase,
    end_tau: Real,
}

// A point of a path, and the fraction of its segment that leads to it.
struct PathPoint {
    x: Real3,
    v: Real3,
    tau: Real,
    fraction: Real,
}

// What a ray saw at its end.
struct Seen {
    end: PathPoint,
    // What surfaces send back; black elsewhere.
    color: vec3f,
    normal: vec3f,
    // The index of the object in the scene file, from 1; 0 for none.
    object: u32,
}

// What a record says of it.
struct Recorded {
    end: PathPoint,
    // The index of the object in the scene file, from 1; 0 for none.
    object: u32,
}
