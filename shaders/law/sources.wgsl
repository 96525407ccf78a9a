// Force centres whose accelerations add (G95 §2.1, W04 §5.2): dv = −Σ strength · d(r) n̂. v is taken as it is: Newtonian
// motion does not keep the speed.

// Further than any scene reaches.
const FAR_AWAY: Real = 1e30;

fn law_acceleration(x: Real3, held: Real) -> Real3 {
    return source_acceleration(x);
}
