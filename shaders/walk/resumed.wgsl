// A segment's walk over the scene may need more iterations than one pass has: it stops where the work runs out, and a later
// pass, which takes the same segment again, goes on from there. What is kept is the piece and the node to visit next (the
// walk's order is fixed), and the best hit of the piece so far.

// Piece in the upper five bits, node in the others; 0 is a walk that has not begun.
@group(0) @binding(70) var walk: texture_storage_2d<r32uint, read_write>;

const NODE_BITS: u32 = 27u;
const NODE_MASK: u32 = 0x07ffffffu;

// The node to go on with, DONE when the piece's walk is complete.
var<private> walk_node: u32;

const DONE: u32 = 0x07ffffffu;

var<private> suspended: bool;

fn walk_begin() -> u32 {
    return walk_node;
}

fn walk_may_go_on() -> bool {
    return work < WORK_LIMIT;
}

fn walk_stop(node: u32, count: u32) {
    walk_node = select(node, DONE, node >= count);
}

fn walked_hit(s: Segment, pixel: vec2u) -> Hit {
    let pieces = segment_pieces(s);
    let kept = textureLoad(walk, pixel).x;
    var hit = Hit(0.0, NOTHING);
    var best = Hit(2.0, NOTHING);
    if kept != 0u {
        best = Hit(Real(textureLoad(hit_t, pixel).x), textureLoad(hit_primitive, pixel).x);
    }
    var k = kept >> NODE_BITS;
    walk_node = kept & NODE_MASK;
    var a = select(piece_end(s, k - 1u, pieces), s.x0, k == 0u);
    loop {
        work += 1u;
        if k >= pieces || hit.primitive != NOTHING {
            break;
        }
        let b = piece_end(s, k, pieces);
        best = piece_hit(a, b, best);
        if walk_node != DONE {
            break;
        }
        hit = Hit(segment_fraction(k, pieces, best.t), best.primitive);
        best = Hit(2.0, NOTHING);
        a = b;
        k += 1u;
        walk_node = 0u;
    }
    suspended = k < pieces && hit.primitive == NOTHING;
    let word = select(0u, (k << NODE_BITS) | walk_node, suspended);
    if word != kept {
        textureStore(walk, pixel, vec4u(word));
    }
    if suspended {
        textureStore(hit_t, pixel, vec4f(f32(best.t)));
        textureStore(hit_primitive, pixel, vec4u(best.primitive));
    }
    return hit;
}

fn walk_suspended() -> bool {
    return suspended;
}

// In the first of a segment's walks always, in the later ones only if it was suspended.
fn walk_needed(pixel: vec2u) -> bool {
    return turn.again == 0u || textureLoad(walk, pixel).x != 0u;
}
