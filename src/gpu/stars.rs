//! Packs the lists of stars.

use glam::{DMat3, DVec2, DVec3};

use super::GpuError;
use super::records::pack;
use super::source::Uploads;
use super::star_buckets::SortedStars;
use crate::model::{Row, row};
use crate::program::Layout;

impl Uploads<'_> {
    /// Packs one of the lists of stars.
    pub(super) fn stars(&self, name: &str, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        let sorted = || self.stars.iter().flatten();
        match name {
            "star_skies" => pack(name, layout, rows(&self.stars)).map(Some),
            "star_list" => {
                let row = |(_, place, flux, kelvins): &(u32, DVec2, f64, f32)| -> Row {
                    row! { place: Vec2(*place), flux: Float(*flux), kelvins: Float(f64::from(*kelvins)) }
                };
                // A buffer may not be empty.
                let none = || row! { place: Vec2(DVec2::ZERO), flux: Float(0.0), kelvins: Float(1.0) };
                let all = sorted().flat_map(|own| own.stars.iter().map(row));
                pack(name, layout, all.chain(std::iter::once_with(none))).map(Some)
            }
            "star_buckets" => {
                let mut first = 0;
                let starts = sorted().flat_map(|own| {
                    let starts = own.starts(first);
                    first += own.stars.len();
                    starts
                });
                Ok(Some(starts.flat_map(u32::to_ne_bytes).collect()))
            }
            "star_means" => {
                let all = sorted().flat_map(SortedStars::means);
                Ok(Some(
                    all.flat_map(|light| light.extend(0.0).as_vec4().to_array()).flat_map(f32::to_ne_bytes).collect(),
                ))
            }
            _ => Ok(None),
        }
    }
}

/// Returns the records of both skies; a sky without stars has no buckets.
fn rows(skies: &[Option<SortedStars>]) -> Vec<Row> {
    let (mut bucket, mut mean) = (0, 0);
    let row = |sky: &Option<SortedStars>| {
        let axes = sky.as_ref().map_or(DMat3::IDENTITY, |own| own.axes);
        let buckets = sky.as_ref().map_or(0, |own| own.buckets);
        let row = row! {
            first: Vec3(axes.x_axis),
            second: Vec3(axes.y_axis),
            third: Vec3(axes.z_axis),
            buckets: Uint(buckets),
            first_bucket: Uint(bucket),
            first_mean: Uint(mean),
            radius: Float(sky.as_ref().map_or(0.0, |own| own.radius)),
            mean: Vec3(sky.as_ref().map_or(DVec3::ZERO, SortedStars::mean)),
        };
        if let Some(own) = sky {
            bucket += 6 * buckets * buckets + 1;
            mean += own.means().len() as u32;
        }
        row
    };
    skies.iter().map(row).collect()
}
