// Which surfaces light goes on through, and what lights want of them.

// Surfaces on one line: more of them let light through without being looked at.
const CROSSINGS: u32 = 64u;

// Of lights as they ask for it; 1 is for light that clear things let through undiminished.
const SHUT_OUT: u32 = 2u;
const WEAKENED: u32 = 3u;

fn is_clear(kind: u32) -> bool {
    if !HAS_ROUGH_GLASS {
        return kind == TRANSMISSIVE;
    }
    return kind == TRANSMISSIVE || kind == FROSTED || kind == MICROFACET;
}

// True for light that clear things shut out.
var<private> shut_out: bool;

fn note_light(shadows: u32) {
    shut_out = shadows == SHUT_OUT;
}

// Does light go straight on through a surface, into the medium behind it?
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
