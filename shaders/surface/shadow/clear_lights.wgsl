// As surface/shadow/clear_rough.wgsl, for lights; what is clear shuts out ambient light.

const CROSSINGS: u32 = 64u;

// True while the line is one of ambient light.
var<private> occluding: bool;

fn mark_occluding(on: bool) {
    occluding = on;
}

fn passes_light(material: u32) -> bool {
    let own = materials[material];
    let passes = !occluding && (own.kind == TRANSMISSIVE || own.kind == FROSTED);
    if passes {
        enter_set(region_bits() ^ (1u << own.bit));
    }
    return passes;
}
