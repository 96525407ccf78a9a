// As surface/shadow/clear_rough.wgsl, for light that asks for it; other light is shut out by what is clear.

const CROSSINGS: u32 = 64u;

var<private> shut_out: bool;

fn note_light(shadows: u32) {
    shut_out = shadows == SHUT_OUT;
}

fn passes_light(material: u32) -> bool {
    let own = materials[material];
    let passes = !shut_out && is_clear(own.kind);
    if passes {
        enter_set(region_bits() ^ (1u << own.bit));
    }
    return passes;
}
