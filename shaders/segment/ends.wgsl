// The end of a path: its last step, its position, its color and its record.

// The last step of a path's last segment.
struct LastStep {
    phase: Phase,
    tau: Real,
    // Its size, in the parameter that `retaken_step` takes.
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

// The surface or sky that a ray saw at its end.
struct Seen {
    end: PathPoint,
    // The light that surfaces send back; black elsewhere.
    color: vec3f,
    normal: vec3f,
    // The index of the object in the scene file, from 1; 0 for none.
    object: u32,
}

// The record of a ray's end.
struct Recorded {
    end: PathPoint,
    // The index of the object in the scene file, from 1; 0 for none.
    object: u32,
}
