// Light goes on through what has an interior, straight on and undiminished.

// Surfaces on one line: more of them let light through without being looked at.
const CROSSINGS: u32 = 64u;

fn passes_light(material: u32) -> bool {
    let own = materials[material];
    let passes = own.kind == TRANSMISSIVE;
    if passes {
        enter_set(region_bits() ^ (1u << own.bit));
    }
    return passes;
}
