// Force centers whose accelerations add (G95 §2.1, W04 §5.2): dv = −Σ strength · d(r) n̂. v is taken as it is: Newtonian motion does not
// conserve the speed.

// A length that is larger than any scene.
const FAR_AWAY: Real = 1e30;

fn law_acceleration(x: Real3, constant: Real) -> Real3 {
    return source_acceleration(x);
}

// Returns the tau to the nearest center.
fn law_scale(p: Phase) -> Real {
    if BY_LENGTH {
        return source_distance(p[0]);
    }
    return source_distance(p[0]) / length(p[1]);
}
