// Random numbers on the points of a lattice, always the same ones: what noise is blended from.

// In [-1, 1]: a hash of a lattice point (PCG's output function on mixed coordinates).
fn lattice(cell: vec3i, seed: u32) -> Real {
    let c = bitcast<vec3u>(cell);
    let mixed = (c.x * 0x8da6b343u) ^ (c.y * 0xd8163841u) ^ (c.z * 0xcb1ab31fu) ^ (seed * 0x9e3779b1u);
    let state = mixed * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return Real(((word >> 22u) ^ word) >> 8u) / 8388607.5 - 1.0;
}
