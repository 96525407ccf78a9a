//! Sorts the stars of a scene's skies into the buckets of `shaders/picture/stars/buckets.wgsl`.

use std::cmp::Ordering;

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
    pub(super) fn sorted(scene: &Scene) -> (Self, StarLists) {
        let [near, beyond] = &scene.stars;
        let mut lists = StarLists::default();
        let first = near.as_ref().map(|stars| lists.add(stars));
        let second = beyond.as_ref().map(|stars| {
            match first.filter(|_| near.as_ref().is_some_and(|near| near.are_those_of(stars))) {
                Some(first) => first,
                None => lists.add(stars),
            }
        });
        (Self { of: scene.stars.clone(), skies: [first, second] }, lists)
    }
}

/// The lists of the stars of all skies, as the device reads them.
#[derive(Debug, Default)]
pub(super) struct StarLists {
    /// The place, flux and temperature of each star of a sky, sorted by buckets; then the color of all light in each bucket of each coarser
    /// level.
    pub(super) rows: Vec<[f32; 4]>,
    /// For each sky the first star of each bucket, and the end of the last one.
    pub(super) buckets: Vec<u32>,
}

impl StarLists {
    /// Appends the stars of a sky.
    fn add(&mut self, stars: &Stars) -> StarSky {
        let all = &stars.catalog.stars;
        let is_shown = |star: &&Star| stars.shows(star);
        let count = all.par_iter().filter(is_shown).count();
        let along_face = buckets_along_face(count);
        let placed = |star: &Star| {
            let (face, place) = on_face(star.direction);
            let [column, row] = place.to_array().map(|at| bucket(at, along_face));
            let star = [place.x as f32, place.y as f32, stars.flux(star) as f32, star.kelvins];
            ((face * along_face + row) * along_face + column, star)
        };
        let placed: Vec<(u32, [f32; 4])> = all.par_iter().filter(is_shown).map(placed).collect();
        let first = self.rows.len();
        let starts = self.sort(&placed, 6 * along_face * along_face);
        let means = means(along_face, &starts, &self.rows);
        let mean = means[means.len() - 6..].iter().copied().sum::<DVec3>() / (4.0 * std::f64::consts::PI);
        let sky = StarSky {
            buckets: along_face,
            first_bucket: self.buckets.len() as u32,
            first_mean: (first + count) as u32,
            mean,
        };
        self.rows.extend(means.iter().map(|light| light.extend(0.0).as_vec4().to_array()));
        self.buckets.extend(starts);
        sky
    }

    /// Appends stars in the order of their buckets, and returns where each bucket starts, and the end of the last one.
    fn sort(&mut self, placed: &[(u32, [f32; 4])], count: u32) -> Vec<u32> {
        let first = self.rows.len();
        // Two further: the start of a bucket is also the place of its next star while the stars are put there.
        let mut starts = vec![0; count as usize + 2];
        starts[0] = first as u32;
        for (bucket, _) in placed {
            starts[*bucket as usize + 2] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        self.rows.resize(first + placed.len(), [0.0; 4]);
        for (bucket, star) in placed {
            let next = &mut starts[*bucket as usize + 1];
            self.rows[*next as usize] = *star;
            *next += 1;
        }
        starts.pop();
        // Catalogs in another order give the same list.
        for range in starts.windows(2).filter(|range| range[1] - range[0] > 1) {
            let key = |star: &[f32; 4]| [star[1], star[0], star[2], star[3]];
            let order = |a: &[f32; 4], b: &[f32; 4]| key(a).partial_cmp(&key(b)).unwrap_or(Ordering::Equal);
            self.rows[range[0] as usize..range[1] as usize].sort_unstable_by(order);
        }
        starts
    }
}

/// Returns the light of all stars in each bucket of each coarser level. starts: as in [`StarLists::buckets`].
fn means(buckets: u32, starts: &[u32], rows: &[[f32; 4]]) -> Vec<DVec3> {
    let mut colors: Vec<Option<DVec3>> = Vec::new();
    let mut color = |kelvins: f32| {
        if kelvins <= 0.0 {
            return DVec3::ONE;
        }
        let step = (f64::from(kelvins).ln() / SAME_COLOR.ln()).round().max(0.0) as usize;
        colors.resize(colors.len().max(step + 1), None);
        *colors[step].get_or_insert_with(|| black_body::color(SAME_COLOR.powf(step as f64)).0)
    };
    let mut size = (buckets / finest_mean()).max(1);
    let mut level = vec![DVec3::ZERO; 6 * (size * size) as usize];
    let factor = buckets / size;
    for (bucket, range) in (0..).zip(starts.windows(2)).filter(|(_, range)| range[0] < range[1]) {
        let (face, row, column) = split(bucket, buckets);
        for [_, _, flux, kelvins] in &rows[range[0] as usize..range[1] as usize] {
            let light = f64::from(*flux) * color(*kelvins);
            level[((face * size + row / factor) * size + column / factor) as usize] += light;
        }
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

/// Returns the size of the lists of a sky with this number of stars, in bytes.
#[must_use]
pub fn star_bytes(stars: usize) -> u64 {
    let buckets = u64::from(buckets_along_face(stars));
    let mut size = (buckets / u64::from(finest_mean())).max(1);
    let mut means = 6 * size * size;
    while size > 1 {
        size /= 2;
        means += 6 * size * size;
    }
    16 * (stars as u64 + means) + 4 * (6 * buckets * buckets + 1)
}

/// Returns the ratio of the widths of the finest means and of buckets.
fn finest_mean() -> u32 {
    constant("picture/stars/buckets", "FINEST_MEAN") as u32
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
