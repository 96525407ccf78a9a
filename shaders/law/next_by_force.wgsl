// G95's Table 1 under forces: v ← v − Σ M d(r) n̂.

fn next_velocity(p: Phase) -> Real3 {
    return p[1] + law_acceleration(p[0], law_held(p));
}
