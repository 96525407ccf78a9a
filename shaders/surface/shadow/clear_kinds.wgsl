// Kinds of surface that light goes on through.

fn is_clear(kind: u32) -> bool {
    return kind == TRANSMISSIVE || kind == FROSTED || kind == MICROFACET;
}
