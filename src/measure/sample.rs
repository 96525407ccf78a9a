//! Which pixels to look at: the same ones in every run.

/// A small generator, so that a measurement can be repeated.
struct Random(u64);

impl Random {
    /// Less than `n`: `SplitMix64`, whose slight preference at such small n is of no account.
    fn below(&mut self, n: u32) -> u32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % u64::from(n)) as u32
    }
}

/// `count` different pixels at random, or all of them if there are no more; others for another seed.
#[must_use]
pub fn scattered(size: [u32; 2], count: usize, seed: u64) -> Vec<[u32; 2]> {
    let mut all = every_pixel(size);
    let count = count.min(all.len());
    let mut random = Random(seed);
    // The first steps of a shuffle.
    for i in 0..count {
        let j = i + random.below((all.len() - i) as u32) as usize;
        all.swap(i, j);
    }
    all.truncate(count);
    all
}

/// The pixels of a whole picture, row by row.
#[must_use]
pub fn every_pixel([width, height]: [u32; 2]) -> Vec<[u32; 2]> {
    (0..height).flat_map(|y| (0..width).map(move |x| [x, y])).collect()
}
