// Kinds of surface that light goes on through, and what lights want of them.

// Of lights as they ask for it; 1 is for light that clear things let through undiminished.
const SHUT_OUT: u32 = 2u;
const WEAKENED: u32 = 3u;

fn is_clear(kind: u32) -> bool {
    return kind == TRANSMISSIVE || kind == FROSTED || kind == MICROFACET;
}
