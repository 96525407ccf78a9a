//! Motion blur: the shutter samples of a frame.
//!
//! *Theory.* A pixel of a camera records the mean over its area and over the time that the shutter is open, which is one more dimension of
//! one integral. Samples are well distributed in all three dimensions if time is the third dimension of the Sobol sequence and the pixel
//! uses the first two: each prefix of a power of two has one sample in each equal interval of any dimension.
//!
//! *Practice.* Each shutter sample is a separate scene with all dependent data, so that all rays of an image sample share one time. Motion
//! by more than a pixel between shutter samples is visible as steps; more shutter samples, and as many image samples, refine them.

use super::Scene;

impl Scene {
    /// Returns the shutter samples of a frame, in frames, in the order of image samples: sample n uses the n-th, starting again after the
    /// last. Returns none if the shutter does not stay open.
    #[must_use]
    pub fn moments(&self, frame: u32) -> Vec<f64> {
        let Some(animation) = self.animation.as_ref().filter(|animation| animation.shutter > 0.0) else {
            return Vec::new();
        };
        let count = animation.moments.min(self.image.samples.next_power_of_two());
        let middle = |n: u32| (f64::from(spread(n, count)) + 0.5) / f64::from(count);
        (0..count).map(|n| f64::from(frame) + animation.shutter * middle(n)).collect()
    }
}

/// Returns the n-th of `count` intervals in the order of the third Sobol dimension, whose matrix has the polynomial x² + x + 1 and the
/// initial numbers 1 and 3; `count` is a power of two.
fn spread(n: u32, count: u32) -> u32 {
    let bits = count.trailing_zeros();
    let mut directions = vec![1_u32, 3];
    for k in 2..bits as usize {
        let (before, last) = (directions[k - 2], directions[k - 1]);
        directions.push((last << 1) ^ (before << 2) ^ before);
    }
    (0..bits)
        .filter(|bit| n >> bit & 1 == 1)
        .map(|bit| directions[bit as usize] << (bits - 1 - bit))
        .fold(0, |a, b| a ^ b)
}

#[cfg(test)]
mod tests {
    use super::spread;

    /// Returns point n of 2^bits points in the first two dimensions, as on the device.
    fn place(n: u32, bits: u32) -> [u32; 2] {
        let reversed = |n: u32| n.reverse_bits() >> (32 - bits);
        let pascal = (0..bits).map(|row| {
            let ones = (row..bits).filter(|&column| n >> column & 1 == 1 && column & row == row).count() as u32;
            (ones & 1) << (bits - 1 - row)
        });
        [reversed(n), pascal.sum()]
    }

    #[test]
    fn every_moment_is_taken_once_in_any_run_of_as_many() {
        for bits in 0..=10 {
            let count = 1 << bits;
            for begin in [0, 1, 5] {
                let mut taken: Vec<u32> = (0..count).map(|n| spread((begin * count + n) % count, count)).collect();
                taken.sort_unstable();
                assert!(taken.into_iter().eq(0..count), "{count}");
            }
        }
        // Prefixes are evenly distributed.
        let mut first: Vec<u32> = (0..16).map(|n| spread(n, 64) / 4).collect();
        first.sort_unstable();
        assert!(first.into_iter().eq(0..16));
    }

    /// Checks that with either axis of the pixel, each box of area 1/n contains one of n points.
    #[test]
    fn moments_are_spread_over_the_pixel() {
        let bits = 6;
        let count = 1 << bits;
        for axis in 0..2 {
            let mut worst = 0;
            for cut in 0..=bits {
                let mut boxes = vec![0; count as usize];
                for n in 0..count {
                    let (along, time) = (place(n, bits)[axis] >> (bits - cut), spread(n, count) >> cut);
                    boxes[(along + (time << cut)) as usize] += 1;
                }
                worst = boxes.into_iter().max().unwrap_or(0).max(worst);
            }
            assert!(worst <= 2, "axis {axis}: {worst} in a box");
        }
    }
}
