//! Sorts the stars of a scene's skies into the buckets of `shaders/picture/stars/buckets.wgsl`.

use glam::{DVec2, DVec3};
use rayon::prelude::*;

use crate::model::black_body;
use crate::program::constant;
use crate::scene::{Scene, Star, Stars};

/// The most buckets along the edge of a face.
const MOST_BUCKETS: u32 = 1024;
/// Temperatures are rounded to this ratio to look up their colors.
const SAME_COLOR: f64 = 1.01;

/// The stars of both skies, as they are on the device.
#[derive(Debug, Clone, Default)]
pub(super) struct StarSkies {
    of: [Option<Stars>; 2],
    skies: [Option<StarSky>; 2],
}

/// The places of one sky in the lists.
#[derive(Debug, Clone, Copy)]
pub(super) struct StarSky {
    /// The number of buckets along the edge of a face.
    pub(super) buckets: u32,
    /// The first bucket.
    pub(super) first_bucket: u32,
    /// The first mean, behind the stars.
    pub(super) first_mean: u32,
    /// The mean radiance of the whole sky.
    pub(super) mean: DVec3,
}

impl StarSkies {
    /// Returns the skies of a scene that have stars, by their sides.
    pub(super) fn of<'s>(&self, scene: &'s Scene) -> [Option<(StarSky, &'s Stars)>; 2] {
        [0, 1].map(|side| self.skies[side].zip(scene.stars[side].as_ref()))
    }

    /// Returns `true` if a scene has the same lists.
    pub(super) fn is_of(&self, scene: &Scene) -> bool {
        self.of.iter().zip(&scene.stars).all(|pair| match pair {
            (Some(a), Some(b)) => a.are_those_of(b),
            (a, b) => a.is_none() && b.is_none(),
        })
    }

    /// Sorts the stars of a scene. Both sides of a wormhole may have the same stars.
    pub(super) fn sorted(scene: &Scene) -> (Self, Vec<SortedStars>) {
        let [near, beyond] = &scene.stars;
        let mut lists = Vec::new();
        let mut sorted = |stars: &Stars| {
            lists.push(SortedStars::of(stars, lists.last()));
            lists.last().map(SortedStars::sky)
        };
        let first = near.as_ref().and_then(&mut sorted);
        let second = beyond.as_ref().and_then(|stars| match near {
            Some(near) if near.are_those_of(stars) => first,
            _ => sorted(stars),
        });
        (Self { of: scene.stars.clone(), skies: [first, second] }, lists)
    }
}

/// The stars of one sky, in buckets.
pub(super) struct SortedStars {
    /// The place of the first star among the stars and means of all skies, and the first bucket.
    first: usize,
    first_bucket: u32,
    /// The number of buckets along the edge of a face.
    buckets: u32,
    /// The bucket, place, flux and temperature of each star, sorted.
    pub(super) stars: Vec<(u32, DVec2, f64, f32)>,
    /// The light of all stars in each bucket of each coarser level.
    pub(super) means: Vec<DVec3>,
}

impl SortedStars {
    /// Sorts stars that follow those of another sky, if any.
    fn of(stars: &Stars, before: Option<&Self>) -> Self {
        let shown: Vec<&Star> = stars.shown().collect();
        let buckets = buckets_along_face(shown.len());
        let place = |star: &Star| {
            let flux = stars.flux(star);
            let (face, place) = on_face(star.direction);
            let [column, row] = place.to_array().map(|at| bucket(at, buckets));
            ((face * buckets + row) * buckets + column, place, flux, star.kelvins)
        };
        let mut sorted: Vec<_> = shown.into_par_iter().map(place).collect();
        sorted.par_sort_unstable_by_key(|star| star.0);
        // Catalogs in another order give the same list.
        sorted.chunk_by_mut(|a, b| a.0 == b.0).for_each(|bucket| {
            bucket.sort_unstable_by(|a, b| {
                let key = |star: &(u32, DVec2, f64, f32)| (star.1.y, star.1.x, star.2, star.3);
                key(a).partial_cmp(&key(b)).unwrap_or(std::cmp::Ordering::Equal)
            });
        });
        let means = means(buckets, &sorted);
        let first = before.map_or(0, |own| own.first + own.stars.len() + own.means.len());
        let first_bucket = before.map_or(0, |own| own.first_bucket + own.bucket_count() + 1);
        Self { first, first_bucket, buckets, stars: sorted, means }
    }

    fn bucket_count(&self) -> u32 {
        6 * self.buckets * self.buckets
    }

    /// Returns the first star of each bucket, and the end of the last one.
    pub(super) fn starts(&self) -> Vec<u32> {
        let mut at = 0;
        let start = |bucket| {
            while self.stars.get(at).is_some_and(|star| star.0 < bucket) {
                at += 1;
            }
            (self.first + at) as u32
        };
        (0..=self.bucket_count()).map(start).collect()
    }

    fn sky(&self) -> StarSky {
        let mean = self.means[self.means.len() - 6..].iter().copied().sum::<DVec3>() / (4.0 * std::f64::consts::PI);
        let first_mean = (self.first + self.stars.len()) as u32;
        StarSky { buckets: self.buckets, first_bucket: self.first_bucket, first_mean, mean }
    }
}

/// Returns the light of all stars in each bucket of each coarser level.
fn means(buckets: u32, stars: &[(u32, DVec2, f64, f32)]) -> Vec<DVec3> {
    let mut colors: Vec<Option<DVec3>> = Vec::new();
    let mut color = |kelvins: f32| {
        if kelvins <= 0.0 {
            return DVec3::ONE;
        }
        let step = (f64::from(kelvins).ln() / SAME_COLOR.ln()).round().max(0.0) as usize;
        colors.resize(colors.len().max(step + 1), None);
        *colors[step].get_or_insert_with(|| black_body::color(SAME_COLOR.powf(step as f64)).0)
    };
    let mut size = (buckets / constant("picture/stars/buckets", "FINEST_MEAN") as u32).max(1);
    let mut level = vec![DVec3::ZERO; 6 * (size * size) as usize];
    let factor = buckets / size;
    for (bucket, _, flux, kelvins) in stars {
        let (face, row, column) = split(*bucket, buckets);
        level[((face * size + row / factor) * size + column / factor) as usize] += *flux * color(*kelvins);
    }
    let mut all = level.clone();
    while size > 1 {
        let half = size / 2;
        let mut coarser = vec![DVec3::ZERO; 6 * (half * half) as usize];
        for (bucket, light) in (0..).zip(&level) {
            let (face, row, column) = split(bucket, size);
            coarser[((face * half + row / 2) * half + column / 2) as usize] += *light;
        }
        all.extend(&coarser);
        (size, level) = (half, coarser);
    }
    all
}

/// Returns the face, row and column of a bucket.
fn split(bucket: u32, buckets: u32) -> (u32, u32, u32) {
    (bucket / (buckets * buckets), bucket / buckets % buckets, bucket % buckets)
}

/// Returns the number of buckets along the edge of a face, a power of two near ¾ of the square root of the number of stars, so that few
/// buckets have several stars.
fn buckets_along_face(stars: usize) -> u32 {
    let power = (0.75 * (stars.max(1) as f64).sqrt()).log2().round().max(0.0);
    (1_u32 << power as u32).min(MOST_BUCKETS)
}

fn bucket(place: f64, buckets: u32) -> u32 {
    ((0.5 * (place + 1.0) * f64::from(buckets)) as u32).min(buckets - 1)
}

/// Returns the face of a direction, +x −x +y −y +z −z, and its place on the face from −1 to 1, along the two axes that follow the face's own.
fn on_face(d: DVec3) -> (u32, DVec2) {
    let axis = d.abs().max_position();
    let (towards, u, v) = (d[axis], d[(axis + 1) % 3], d[(axis + 2) % 3]);
    (2 * axis as u32 + u32::from(towards < 0.0), DVec2::new(u, v) / towards.abs())
}
