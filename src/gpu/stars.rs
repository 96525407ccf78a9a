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
                let starts: Vec<u32> = self.stars.iter().flat_map(SortedStars::starts).collect();
                Ok(Some(bytemuck::cast_slice(&starts).to_vec()))
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
    skies.map(|own| {
        let (sky, stars) = own.unzip();
        let axes = stars.map_or(DMat3::IDENTITY, |stars| stars.rotation);
        row! {
            first: Vec3(axes.x_axis),
            second: Vec3(axes.y_axis),
            third: Vec3(axes.z_axis),
            buckets: Uint(sky.map_or(0, |sky| sky.buckets)),
            first_bucket: Uint(sky.map_or(0, |sky| sky.first_bucket)),
            first_mean: Uint(sky.map_or(0, |sky| sky.first_mean)),
            radius: Float(stars.map_or(0.0, |stars| 0.5 * stars.size)),
            mean: Vec3(sky.map_or(DVec3::ZERO, |sky| sky.mean)),
        }
    })
}
