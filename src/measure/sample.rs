//! The choice of random pixels, which is repeatable.

use std::collections::HashMap;

/// A small generator with a fixed seed, so that a measurement can be repeated.
struct Random(u64);

impl Random {
    /// Returns a number below `n` by `SplitMix64`, whose bias is negligible for such small n.
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % n
    }
}

/// Returns `count` different random pixels, or all of them if there are fewer; another seed returns others.
#[must_use]
pub fn scattered(size: [u32; 2], count: usize, seed: u64) -> Vec<[u32; 2]> {
    let [width, height] = size.map(u64::from);
    let all = width * height;
    let mut random = Random(seed);
    // The first steps of a shuffle of all pixels, which stores only the pixels that have moved.
    let mut moved = HashMap::new();
    let step = |i: u64| {
        let j = i + random.below(all - i);
        let here = moved.remove(&i).unwrap_or(i);
        if j == i { here } else { moved.insert(j, here).unwrap_or(j) }
    };
    (0..all.min(count as u64)).map(step).map(|at| [(at % width) as u32, (at / width) as u32]).collect()
}

/// Returns the pixels of a whole image, row by row.
#[must_use]
pub fn every_pixel([width, height]: [u32; 2]) -> Vec<[u32; 2]> {
    (0..height).flat_map(|y| (0..width).map(move |x| [x, y])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_differ_and_are_those_of_a_shuffle() {
        let size = [7, 5];
        let mut shuffled = every_pixel(size);
        let mut random = Random(9);
        for i in 0..35 {
            let j = i + random.below(35 - i as u64) as usize;
            shuffled.swap(i, j);
        }
        assert_eq!(scattered(size, 35, 9), shuffled);
        assert_eq!(scattered(size, 12, 9), shuffled[..12]);
        assert_eq!(scattered([u32::MAX; 2], 3, 1).len(), 3);
    }
}
