// Returns the end of a path that an earlier render has followed.

var<private> stored_end: StoredEnd;

fn path_end(ray: Ray, hit: Hit) -> PathPoint {
    if FOLLOWS_SHIFT {
        restore_stretch(stored_end.stretch);
    }
    return PathPoint(Real3(stored_end.x), Real3(stored_end.v), stored_end.tau, 0.0);
}
