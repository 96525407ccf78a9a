// Correlated multi-jittered samples (Kensler 2013): stratified in both axes and in the plane, without tables.

struct Sampling {
    // The columns and rows of the pattern; their product is at least the number of samples.
    grid: vec2u,
}

var<uniform> sampling: Sampling;

// Returns the image of `index` under a permutation of 0 … l − 1 that p selects: an invertible hash on the next power of two, repeated until
// the result is below l.
fn permuted(index: u32, l: u32, p: u32) -> u32 {
    var mask = l - 1u;
    mask |= mask >> 1u;
    mask |= mask >> 2u;
    mask |= mask >> 4u;
    mask |= mask >> 8u;
    mask |= mask >> 16u;
    var i = index;
    loop {
        i ^= p;
        i *= 0xe170893du;
        i ^= p >> 16u;
        i ^= (i & mask) >> 4u;
        i ^= p >> 8u;
        i *= 0x0929eb3fu;
        i ^= p >> 23u;
        i ^= (i & mask) >> 1u;
        i *= 1u | (p >> 27u);
        i *= 0x6935fa69u;
        i ^= (i & mask) >> 11u;
        i *= 0x74dcb303u;
        i ^= (i & mask) >> 2u;
        i *= 0x9e501cc3u;
        i ^= (i & mask) >> 2u;
        i *= 0xc860a3dfu;
        i &= mask;
        i ^= i >> 5u;
        if i < l {
            break;
        }
    }
    return (i + p) % l;
}

// Returns a pseudo-random number in [0, 1).
fn unit_random(seed: u32) -> f32 {
    return f32(hashed(seed) >> 8u) / 16777216.0;
}

fn nth_point(pixel: vec2u, n: u32) -> vec2f {
    let seed = pattern_seed(pixel);
    let s = permuted(n, sampling.grid.x * sampling.grid.y, seed * 0x51633e2du);
    let column = s % sampling.grid.x;
    let row = s / sampling.grid.x;
    let sx = permuted(column, sampling.grid.x, seed * 0x68bc21ebu);
    let sy = permuted(row, sampling.grid.y, seed * 0x02e5be93u);
    let jx = unit_random(s ^ (seed * 0x967a889bu));
    let jy = unit_random(s ^ (seed * 0x368cc8b7u));
    let x = (f32(column) + (f32(sy) + jx) / f32(sampling.grid.y)) / f32(sampling.grid.x);
    let y = (f32(row) + (f32(sx) + jy) / f32(sampling.grid.x)) / f32(sampling.grid.y);
    return vec2f(pixel) + vec2f(x, y);
}
