//! Packs the lists of stars.

use glam::{DMat3, DVec2, DVec3};
use rayon::prelude::*;

use super::GpuError;
use super::records::pack;
use super::source::Uploads;
use super::star_buckets::StarSky;
use crate::model::{Row, row};
use crate::program::Layout;
use crate::scene::Stars;

impl Uploads<'_> {
    /// Packs one of the lists of stars.
    pub(super) fn stars(&self, name: &str, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        let sorted = || self.stars.iter();
        match name {
            "star_skies" => pack(name, layout, rows(self.star_skies.of(self.scene))).map(Some),
            "star_list" => {
                let all: Vec<_> = sorted().flat_map(|own| &own.stars).collect();
                packed(layout, &all).map(Some)
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
                let all = sorted().flat_map(|own| own.means.iter().copied());
                Ok(Some(
                    all.flat_map(|light| light.extend(0.0).as_vec4().to_array()).flat_map(f32::to_ne_bytes).collect(),
                ))
            }
            _ => Ok(None),
        }
    }
}

/// Returns stars as the device reads them. The first is packed and checked like all other values, and the others like the first.
fn packed(layout: &Layout, stars: &[&(u32, DVec2, f64, f32)]) -> Result<Vec<u8>, GpuError> {
    let row = |place: DVec2, flux, kelvins| -> Row {
        row! { place: Vec2(place), flux: Float(flux), kelvins: Float(kelvins) }
    };
    // A buffer may not be empty.
    let first = stars.first().map_or(row(DVec2::ZERO, 0.0, 1.0), |own| row(own.1, own.2, own.3.into()));
    let first = pack("star_list", layout, [first])?;
    let offsets = ["place", "flux", "kelvins"].map(|name| layout.field(name).map_or(0, |field| field.offset as usize));
    let span = layout.span as usize;
    let mut bytes = vec![0; span * stars.len()];
    bytes.par_chunks_exact_mut(span).zip(stars).for_each(|(bytes, (_, place, flux, kelvins))| {
        let mut put = |at: usize, value: f32| bytes[at..at + 4].copy_from_slice(&value.to_ne_bytes());
        put(offsets[0], place.x as f32);
        put(offsets[0] + 4, place.y as f32);
        put(offsets[1], *flux as f32);
        put(offsets[2], *kelvins);
    });
    debug_assert!(bytes.is_empty() || bytes.starts_with(&first));
    Ok(if bytes.is_empty() { first } else { bytes })
}

/// Returns the records of both skies; a sky without stars has no buckets.
fn rows(skies: [Option<(StarSky, &Stars)>; 2]) -> [Row; 2] {
    let (mut bucket, mut mean) = (0, 0);
    skies.map(|own| {
        let axes = own.map_or(DMat3::IDENTITY, |(_, stars)| stars.rotation);
        let buckets = own.map_or(0, |(sky, _)| sky.buckets);
        let row = row! {
            first: Vec3(axes.x_axis),
            second: Vec3(axes.y_axis),
            third: Vec3(axes.z_axis),
            buckets: Uint(buckets),
            first_bucket: Uint(bucket),
            first_mean: Uint(mean),
            radius: Float(own.map_or(0.0, |(_, stars)| 0.5 * stars.size)),
            mean: Vec3(own.map_or(DVec3::ZERO, |(sky, _)| sky.mean)),
        };
        if let Some((sky, _)) = own {
            bucket += 6 * buckets * buckets + 1;
            mean += sky.means;
        }
        row
    })
}
