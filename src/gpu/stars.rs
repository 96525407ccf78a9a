//! Packs the lists of stars.

use glam::{DMat3, DVec3};

use super::GpuError;
use super::records::pack;
use super::source::Uploads;
use super::star_buckets::StarSky;
use crate::model::{Row, row};
use crate::program::Layout;
use crate::scene::Stars;

impl Uploads<'_> {
    /// Packs the records of the skies.
    pub(super) fn star_skies(&self, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        pack("star_skies", layout, rows(self.star_skies.of(self.scene))).map(Some)
    }

    /// Returns one of the long lists of stars, which are not copied again.
    pub(super) fn star_list(&self, name: &str) -> Option<&[u8]> {
        match name {
            "star_list" => Some(bytemuck::cast_slice(&self.stars.rows)),
            "star_buckets" => Some(bytemuck::cast_slice(&self.stars.buckets)),
            _ => None,
        }
    }
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
