// Chooses between two rays, the reflected and the transmitted one. With random splitting one of them is followed, with a probability equal
// to its share of the light, so that every ray has equal weight; rays that are traced, without a throughput, follow the transmitted one.
//
// With exact splitting both are followed, without a stack and without noise: the whole path is followed again for every leaf of its tree.
// Bit k of a pixel's code selects the ray at the k-th split: 0 transmits, 1 reflects. Codes follow a depth-first walk: the next code
// differs at the last split whose reflected ray has not been followed, so that a tree of n leaves takes n rounds, whatever its depth. After
// the last leaf the pixel rests.

struct Branching {
    // The largest number of splits along a path.
    depth: u32,
}

var<uniform> branching: Branching;
// The code, and above MET the number of splits that the path has met; the highest bit is for surfaces that end paths by a split.
var<storage, read_write> pixel_branches: array<u32>;

const MET: u32 = 24u;

const MET_BITS: u32 = 5u;

var<private> branch_code: u32;

fn load_branches(pixel: vec2u) {
    if ENUMERATES {
        branch_code = pixel_branches[place_in_tile(pixel)];
    }
}

fn store_branches(pixel: vec2u) {
    if ENUMERATES {
        pixel_branches[place_in_tile(pixel)] = branch_code;
    }
}

fn low_bits(n: u32) -> u32 {
    return (1u << n) - 1u;
}

fn branches_met() -> u32 {
    return extractBits(branch_code, MET, MET_BITS);
}

// Returns the splits of the last path whose reflected rays have not been followed.
fn open_branches() -> u32 {
    return ~branch_code & low_bits(branches_met());
}

fn branches_left(pixel: vec2u) -> bool {
    load_branches(pixel);
    return open_branches() != 0u;
}

// Starts a branch, and returns `false` if the pixel has no path left.
fn begin_branches(pixel: vec2u) -> bool {
    if !ENUMERATES {
        return true;
    }
    if frame.branch == 0u {
        branch_code = 0u;
        return true;
    }
    load_branches(pixel);
    let open = open_branches();
    if open == 0u {
        return false;
    }
    let k = firstLeadingBit(open);
    branch_code = (branch_code & low_bits(k)) | (1u << k);
    return true;
}

fn chosen_branch(pixel: vec2u, index: u32, reflectance: f32) -> Branch {
    if ENUMERATES {
        let met = branches_met();
        if met >= branching.depth {
            return Branch(false, 0.0, true);
        }
        branch_code += 1u << MET;
        let reflects = ((branch_code >> met) & 1u) == 1u;
        return Branch(reflects, select(1.0 - reflectance, reflectance, reflects), false);
    }
    if FOLLOWS_PATHS {
        // The choices at one surface are in the upper bits.
        return Branch(path_point(pixel, BRANCH + (index >> 16u)).x < reflectance, 1.0, false);
    }
    if !DRAWS {
        return Branch(false, 1.0, false);
    }
    let whole = frame.origin + pixel;
    let seed = (whole.x * 0x9e3779b1u) ^ (whole.y * 0x85ebca77u) ^ (frame.sample * 0xc2b2ae3du) ^ (index * 0x27d4eb2fu);
    return Branch(f32(hashed(seed) >> 8u) / 16777216.0 < reflectance, 1.0, false);
}

// Returns `true` if no other branch has counted the emission of media here: the first of all paths that share this stretch does, the one
// whose later splits all transmit.
fn glow_is_new() -> bool {
    if !ENUMERATES {
        return true;
    }
    return ((branch_code & low_bits(MET)) >> branches_met()) == 0u;
}

// True if no other branch has added the emission on this stretch.
var<private> glow_counts: bool;

// Records whether emission along the path counts, before a surface splits the ray.
fn note_glow() {
    glow_counts = glow_is_new();
}
