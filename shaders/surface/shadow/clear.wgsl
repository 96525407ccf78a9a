// Decides which surfaces transmit light to others, as each light specifies.

// The number of surfaces on one line that are evaluated; further ones transmit light without a test.
const CROSSINGS: u32 = 64u;

// The setting of lights that transparent objects block; 1 is for light that they transmit undiminished.
const SHUT_OUT: u32 = 2u;
const WEAKENED: u32 = 3u;

fn is_clear(kind: u32) -> bool {
    if !HAS_ROUGH_GLASS {
        return kind == TRANSMISSIVE;
    }
    return kind == TRANSMISSIVE || kind == FROSTED || kind == MICROFACET;
}

// True for light that transparent objects block.
var<private> shut_out: bool;

fn note_light(shadows: u32) {
    shut_out = shadows == SHUT_OUT;
}

// Returns `true` if light passes straight through a surface, into the medium behind it.
fn passes_light(material: u32) -> bool {
    if !SPLITS {
        return false;
    }
    let own = materials[material];
    var passes = is_clear(own.kind);
    if SHUTS_OUT {
        passes = passes && !shut_out;
    }
    if passes {
        enter_set(region_bits() ^ (1u << own.bit));
    }
    return passes;
}
