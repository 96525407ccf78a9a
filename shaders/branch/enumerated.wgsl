// Both, without a stack and without noise: the whole path is followed anew for every leaf of its tree. Bit k of a pixel's code
// says which ray is taken at the k-th branching: 0 transmits, 1 reflects. Codes are taken in the order of a depth-first walk:
// the next one differs at the last branching whose reflected ray has not been followed, so that a tree of n leaves takes n
// rounds, whatever its depth; with all of them followed, the pixel rests.

struct Branching {
    // Branchings along a path, at most.
    depth: u32,
}

@group(0) @binding(109) var<uniform> branching: Branching;
// The code, and above MET how many branchings the path has met.
@group(0) @binding(108) var branches: texture_storage_2d<r32uint, read_write>;

const MET: u32 = 24u;

fn low_bits(n: u32) -> u32 {
    return (1u << n) - 1u;
}

// The branchings of a path whose reflected rays have not been followed.
fn open_branches(word: u32) -> u32 {
    return ~word & low_bits(word >> MET);
}

fn branches_left(pixel: vec2u) -> bool {
    return open_branches(textureLoad(branches, pixel).x) != 0u;
}

// False where the pixel has no path left.
fn begin_branches(pixel: vec2u) -> bool {
    if frame.branch == 0u {
        textureStore(branches, pixel, vec4u(0u));
        return true;
    }
    let last = textureLoad(branches, pixel).x;
    let open = open_branches(last);
    if open == 0u {
        return false;
    }
    let k = firstLeadingBit(open);
    textureStore(branches, pixel, vec4u((last & low_bits(k)) | (1u << k)));
    return true;
}

fn chosen_branch(pixel: vec2u, index: u32, reflectance: f32) -> Branch {
    let word = textureLoad(branches, pixel).x;
    let met = word >> MET;
    if met >= branching.depth {
        return Branch(false, 0.0, true);
    }
    textureStore(branches, pixel, vec4u(word + (1u << MET)));
    let reflects = ((word >> met) & 1u) == 1u;
    return Branch(reflects, select(1.0 - reflectance, reflectance, reflects), false);
}
