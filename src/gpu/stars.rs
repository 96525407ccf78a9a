//! Packs the lists of stars.

use glam::{DMat3, DVec2, DVec3};
use rayon::prelude::*;

use super::GpuError;
use super::records::pack;
use super::source::Uploads;
use super::star_buckets::{SortedStars, StarSky};
use crate::model::{Row, row};
use crate::program::Layout;
use crate::scene::Stars;

impl Uploads<'_> {
    /// Packs one of the lists of stars.
    pub(super) fn stars(&self, name: &str, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        match name {
            "star_skies" => pack(name, layout, rows(self.star_skies.of(self.scene))).map(Some),
            "star_list" => Ok(Some(list(&self.stars))),
            "star_buckets" => {
                let mut first = 0;
                let starts = self.stars.iter().flat_map(|own| {
                    let starts = own.starts(first);
                    first += own.stars.len() + own.means.len();
                    starts
                });
                Ok(Some(bytemuck::cast_slice(&starts.collect::<Vec<u32>>()).to_vec()))
            }
            _ => Ok(None),
        }
    }
}

/// Returns the stars and means of each sky as the device reads them: a place, a flux and a temperature, or a color.
fn list(skies: &[SortedStars]) -> Vec<u8> {
    let star =
        |(_, place, flux, kelvins): &(u32, DVec2, f64, f32)| [place.x as f32, place.y as f32, *flux as f32, *kelvins];
    let mean = |light: &DVec3| light.extend(0.0).as_vec4().to_array();
    let rows = |own: &SortedStars| -> Vec<[f32; 4]> {
        own.stars.par_iter().map(star).chain(own.means.par_iter().map(mean)).collect()
    };
    let all: Vec<_> = skies.iter().flat_map(rows).collect();
    bytemuck::cast_slice(&all).to_vec()
}

/// Returns the records of both skies; a sky without stars has no buckets.
fn rows(skies: [Option<(StarSky, &Stars)>; 2]) -> [Row; 2] {
    let (mut bucket, mut first) = (0, 0);
    skies.map(|own| {
        let axes = own.map_or(DMat3::IDENTITY, |(_, stars)| stars.rotation);
        let buckets = own.map_or(0, |(sky, _)| sky.buckets);
        let row = row! {
            first: Vec3(axes.x_axis),
            second: Vec3(axes.y_axis),
            third: Vec3(axes.z_axis),
            buckets: Uint(buckets),
            first_bucket: Uint(bucket),
            first_mean: Uint(first + own.map_or(0, |(sky, _)| sky.stars)),
            radius: Float(own.map_or(0.0, |(_, stars)| 0.5 * stars.size)),
            mean: Vec3(own.map_or(DVec3::ZERO, |(sky, _)| sky.mean)),
        };
        if let Some((sky, _)) = own {
            bucket += 6 * buckets * buckets + 1;
            first += sky.stars + sky.means;
        }
        row
    })
}
