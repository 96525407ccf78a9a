//! Which pixels to look at: the same ones in every run.

use std::collections::HashMap;

/// A small generator, so that a measurement can be repeated.
struct Random(u64);

impl Random {
    /// Less than `n`: `SplitMix64`, whose slight preference at such small n is of no account.
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % n
    }
}

/// `count` different pixels at random, or all of them if there are no more; others for another seed.
#[must_use]
pub fn scattered(size: [u32; 2], count: usize, seed: u64) -> Vec<[u32; 2]> {
    let [width, height] = size.map(u64::from);
    let all = width * height;
    let mut random = Random(seed);
    // The first steps of a shuffle of all pixels, of which only those are kept that are not in their own place any more.
    let mut moved = HashMap::new();
    let step = |i: u64| {
        let j = i + random.below(all - i);
        let here = moved.remove(&i).unwrap_or(i);
        if j == i { here } else { moved.insert(j, here).unwrap_or(j) }
    };
    (0..all.min(count as u64)).map(step).map(|at| [(at % width) as u32, (at / width) as u32]).collect()
}

/// The pixels of a whole picture, row by row.
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
