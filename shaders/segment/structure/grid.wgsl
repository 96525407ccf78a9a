// A uniform grid of cells, each with the items whose boxes overlap it, walked from cell to cell along each piece of a segment (Amanatides
// and Woo 1987; G95 §4 walks arcs in this way). The warm start of G95, at the cell where the segment before ended, is unnecessary here:
// three divisions find the first cell of a piece.

struct GridSpace {
    lo: Real3,
    hi: Real3,
    // The size of a cell.
    cell: Real3,
    // The number of cells along each axis.
    count: vec3u,
}

var<uniform> grid_space: GridSpace;
// The start of each cell's items, and after the last cell their end.
var<storage, read> cells: array<u32>;

// A suspended walk stores a piece, in the upper five bits, and a cell, counted from 1.
const CELL_BITS: u32 = 27u;
const CELL_MASK: u32 = 0x07ffffffu;

// Returns the cell that contains a position, or the nearest one.
fn cell_at(x: Real3) -> vec3u {
    let limit = Real3(grid_space.count - 1u);
    return vec3u(clamp(floor((x - grid_space.lo) / grid_space.cell), Real3(0.0), limit));
}

fn cell_index(cell: vec3u) -> u32 {
    return cell.x + grid_space.count.x * (cell.y + grid_space.count.y * cell.z);
}

fn cell_of(index: u32) -> vec3u {
    let row = index / grid_space.count.x;
    return vec3u(index % grid_space.count.x, row % grid_space.count.y, row / grid_space.count.y);
}

// Returns the fractions at which the piece from a, with 1/d given, enters and leaves the grid.
fn grid_span(a: Real3, inverse: Real3) -> Span {
    let t0 = (grid_space.lo - a) * inverse;
    let t1 = (grid_space.hi - a) * inverse;
    let near = min(t0, t1);
    let far = max(t0, t1);
    return Span(
        max(max(near.x, near.y), max(near.z, -overlap())),
        min(min(far.x, far.y), min(far.z, 1.0 + OVERLAP)),
    );
}

// Returns the fraction at which the piece leaves a cell along each axis.
fn cell_exits(cell: vec3u, a: Real3, inverse: Real3) -> Real3 {
    let ahead = select(cell, cell + 1u, inverse > Real3(0.0));
    return (grid_space.lo + Real3(ahead) * grid_space.cell - a) * inverse;
}

fn structure_hit(s: Segment, pieces: u32, nearest: Hit) -> Hit {
    var hit = nearest;
    let kept = walk_begin();
    var k = select(kept >> CELL_BITS, pieces, pieces == 0u);
    var begun = kept & CELL_MASK;
    // A piece with a hit is the last one.
    var stopped = false;
    while k < pieces && hit.t * Real(pieces) >= Real(k) - PIECE_SLACK && !stopped && walk_has_room() {
        let a = piece_start(s, k, pieces);
        let d = piece_end(s, k, pieces) - a;
        let inverse = 1.0 / select(d, Real3(1e-30), abs(d) < Real3(1e-30));
        let inside = grid_span(a, inverse);
        var cell = cell_at(a + max(inside.enters, 0.0) * d);
        if begun != 0u {
            cell = cell_of(begun - 1u);
        }
        begun = 0u;
        var walking = inside.enters <= inside.leaves;
        while walking {
            let index = cell_index(cell);
            let count = cells[index + 1u] - cells[index];
            if !walk_has_room_for(count) {
                begun = index + 1u;
                stopped = true;
                break;
            }
            let at = (Real(k) + 0.5) / Real(pieces);
            hit = items_hit(s, pieces, Span(at, at), cells[index], count, hit);
            walk_turn();
            let exits = cell_exits(cell, a, inverse);
            let leaves = min(exits.x, min(exits.y, exits.z));
            let axis = select(select(vec3u(0u, 0u, 1u), vec3u(0u, 1u, 0u), exits.y == leaves), vec3u(1u, 0u, 0u), exits.x == leaves);
            // A number below 0 wraps around to beyond the last cell.
            cell = select(cell - axis, cell + axis, inverse > Real3(0.0));
            walking = leaves <= 1.0 + OVERLAP && all(cell < grid_space.count)
                && Real(k) + leaves <= hit.t * Real(pieces) + PIECE_SLACK;
        }
        if begun == 0u {
            k += 1u;
        }
    }
    let done = k >= pieces || hit.t * Real(pieces) < Real(k) - PIECE_SLACK;
    walk_stop((k << CELL_BITS) | begun, done);
    return hit;
}
