// No orbit of light lies where rays that move inwards are captured: none of them turns.

fn orbit_turns(o: Orbit) -> bool {
    return false;
}
