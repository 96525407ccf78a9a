// As surface/shadow/clear_rough.wgsl, for lights; what is clear shuts out ambient light.

const CROSSINGS: u32 = 64u;

fn passes_light(material: u32) -> bool {
    let own = materials[material];
    let passes = !occluding && (own.kind == TRANSMISSIVE || own.kind == FROSTED);
    if passes {
        enter_set(region_bits() ^ (1u << own.bit));
    }
    return passes;
}
