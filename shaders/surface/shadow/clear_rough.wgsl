// As surface/shadow/clear.wgsl, through rough surfaces too.

const CROSSINGS: u32 = 64u;

fn passes_light(material: u32) -> bool {
    let own = materials[material];
    let passes = is_clear(own.kind);
    if passes {
        enter_set(region_bits() ^ (1u << own.bit));
    }
    return passes;
}
