//! Importance sampling of the sky: the bright cells of its environment map, which paths sample in addition to emitters.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};
use rayon::prelude::*;

use super::{Picture, Scene, Sky};

/// A sphere in cells of equal longitude and latitude, oriented like an equirectangular map.
#[derive(Debug, Clone, PartialEq)]
pub struct SkyCells {
    /// The sum over the sphere of the radiance above the mean, averaged over colors, times the solid angle.
    pub total: f32,
    /// The cumulative fraction of the sum at the end of each row, from the top.
    pub rows: Vec<f32>,
    /// The cumulative fraction within each row at the end of each cell, row by row.
    pub cells: Vec<f32>,
}

impl SkyCells {
    /// Creates the cells of a sky with the mean radiance `mean(column, row)`, averaged over colors.
    fn of([columns, rows]: [u32; 2], mean: impl Fn(u32, u32) -> f64 + Sync) -> Self {
        let angle = |row: u32| PI * f64::from(row) / f64::from(rows);
        let solid = |row: u32| 2.0 * PI / f64::from(columns) * (angle(row).cos() - angle(row + 1).cos());
        let row = |row: u32| (0..columns).map(|column| mean(column, row)).collect::<Vec<_>>();
        let radiance: Vec<Vec<f64>> = (0..rows).into_par_iter().map(row).collect();
        let power = |(row, radiance): (u32, &Vec<f64>)| solid(row) * radiance.iter().sum::<f64>();
        let even = (0..rows).zip(&radiance).map(power).sum::<f64>() / (4.0 * PI);
        let bright = |radiance: &Vec<f64>| radiance.iter().map(|x| (x - even).max(0.0)).collect::<Vec<_>>();
        let bright: Vec<Vec<f64>> = radiance.iter().map(bright).collect();
        let of_rows: Vec<f64> = (0..rows).zip(&bright).map(power).collect();
        Self {
            total: of_rows.iter().sum::<f64>() as f32,
            rows: sums(&of_rows),
            cells: bright.iter().flat_map(|row| sums(row)).collect(),
        }
    }
}

/// Returns cumulative sums divided by the total, or evenly distributed values if the total is zero.
fn sums(values: &[f64]) -> Vec<f32> {
    let all: f64 = values.iter().sum();
    let even = 1.0 / values.len() as f64;
    let mut sum = 0.0;
    let mut next = |x: &f64| {
        sum += if all > 0.0 { x / all } else { even };
        sum as f32
    };
    let mut sums: Vec<f32> = values.iter().map(&mut next).collect();
    // After the last positive value all sums are 1, so that rounding cannot select a zero.
    let end = values.iter().rposition(|x| *x > 0.0).unwrap_or(values.len() - 1);
    sums[end..].fill(1.0);
    sums
}

/// The variance of the sky's radiance, relative to the square of its mean, above which an additional ray is worth its time.
const WORTH_AIMING: f64 = 0.25;

/// Returns the weighted sums of 1, radiance averaged over colors, and its square over the pixels of an image; `weight` takes coordinates
/// from −1 to 1.
fn weighed(picture: &Picture, weight: impl Fn(f64, f64) -> f64 + Sync) -> DVec3 {
    let [width, height] = picture.size.map(f64::from);
    let place = |k: usize, size: f64| 2.0 * (k as f64 + 0.5) / size - 1.0;
    let rows = picture.pixels.par_chunks(picture.size[0] as usize).enumerate();
    let row = |(j, row): (usize, &[[f32; 3]])| -> DVec3 {
        let y = place(j, height);
        let of_pixel = |(i, pixel): (usize, &[f32; 3])| {
            let light = f64::from(pixel.iter().sum::<f32>()) / 3.0;
            weight(place(i, width), y) * DVec3::new(1.0, light, light * light)
        };
        row.iter().enumerate().map(of_pixel).sum()
    };
    // Summed in order, so that the sum does not depend on the number of cores.
    let sums: Vec<DVec3> = rows.map(row).collect();
    sums.iter().sum::<DVec3>() / (width * height)
}

impl Scene {
    /// Returns `true` if paths sample the sky because its radiance varies; a uniform sky needs no sampling.
    #[must_use]
    pub fn aims_at_sky(&self) -> bool {
        let wanted = self.rays.path_tracing.is_some_and(|paths| paths.light_sampling);
        let faces: Vec<&Picture> = match &self.sky {
            _ if !wanted => return false,
            Sky::Color(_) | Sky::Transparent => return false,
            Sky::Equirectangular(picture, ..) => vec![&self.pictures[*picture]],
            Sky::Faces(faces, ..) => faces.iter().map(|face| &self.pictures[*face]).collect(),
        };
        // The solid angle of a pixel, up to a constant.
        let weight = |x: f64, y: f64| match faces.len() {
            1 => (0.5 * PI * y).cos(),
            _ => (1.0 + x * x + y * y).powf(-1.5),
        };
        let [solid, light, squares] = faces.iter().map(|face| weighed(face, weight)).sum::<DVec3>().to_array();
        squares * solid > (1.0 + WORTH_AIMING) * light * light
    }

    /// Returns the sky in columns and rows.
    #[must_use]
    pub fn sky_cells(&self, size: [u32; 2]) -> SkyCells {
        let [columns, rows] = size.map(f64::from);
        // Each side of a cell has as many points as pixels of the image, so that no pixel is skipped.
        let points = (self.sky_pixels_around() / columns).ceil().max(1.0) as u32;
        SkyCells::of(size, |column, row| {
            let at = |cell: u32, k: u32| f64::from(cell) + (f64::from(k) + 0.5) / f64::from(points);
            let place = |k: u32| DVec2::new(at(column, k % points) / columns, at(row, k / points) / rows);
            let sum: f64 = (0..points * points).map(|k| self.sky_brightness(place(k))).sum();
            sum / f64::from(points * points)
        })
    }

    /// Returns the number of pixels around the sky at their greatest density.
    fn sky_pixels_around(&self) -> f64 {
        match self.sky {
            Sky::Color(_) | Sky::Transparent => 1.0,
            Sky::Equirectangular(picture, ..) => f64::from(self.pictures[picture].size[0]),
            // A pixel at the center of a face is 4/π as wide as the mean pixel, and less than half as wide at a corner.
            Sky::Faces(faces, ..) => {
                let widest = faces.iter().map(|face| self.pictures[*face].size[0]).max().unwrap_or(1);
                2.0 * PI * f64::from(widest)
            }
        }
    }

    /// Returns the radiance, averaged over colors, at a position of the sphere relative to its top left, as `shaders/picture/sky` does.
    fn sky_brightness(&self, place: DVec2) -> f64 {
        match self.sky {
            Sky::Color(color) => color.element_sum() / 3.0,
            Sky::Transparent => 0.0,
            Sky::Equirectangular(picture, intensity, rotation) => {
                let d = rotation.transpose() * at_place(place);
                let own = DVec2::new(0.5 + d.x.atan2(-d.z) / (2.0 * PI), d.y.clamp(-1.0, 1.0).acos() / PI);
                intensity * sample(&self.pictures[picture], own, true)
            }
            Sky::Faces(faces, intensity, rotation) => {
                let (face, at) = on_face(rotation.transpose() * at_place(place));
                intensity * sample(&self.pictures[faces[face]], at, false)
            }
        }
    }
}

/// Returns the direction at a position of the sphere relative to its top left.
fn at_place(place: DVec2) -> DVec3 {
    let (around, down) = (2.0 * PI * (place.x - 0.5), PI * place.y);
    DVec3::new(down.sin() * around.sin(), down.cos(), -down.sin() * around.cos())
}

/// Returns the index among the faces +x −x +y −y +z −z in a direction, and the position on the face from its top left.
fn on_face(d: DVec3) -> (usize, DVec2) {
    let size = d.abs();
    let (face, p) = if size.x >= size.y.max(size.z) {
        (usize::from(d.x <= 0.0), DVec3::new(d.x.signum() * d.z, d.y, size.x))
    } else if size.y >= size.z {
        (2 + usize::from(d.y <= 0.0), DVec3::new(d.x, d.y.signum() * d.z, size.y))
    } else {
        (4 + usize::from(d.z <= 0.0), DVec3::new(-d.z.signum() * d.x, d.y, size.z))
    };
    (face, 0.5 + 0.5 * DVec2::new(p.x, -p.y) / p.z)
}

/// Returns a bilinear sample of an image, averaged over colors.
fn sample(picture: &Picture, place: DVec2, repeats: bool) -> f64 {
    let [width, height] = picture.size.map(i64::from);
    let p = place * DVec2::new(width as f64, height as f64) - 0.5;
    let (base, f) = (p.floor(), p - p.floor());
    let pixel = |dx: i64, dy: i64| {
        let x = base.x as i64 + dx;
        let x = if repeats { x.rem_euclid(width) } else { x.clamp(0, width - 1) };
        let y = (base.y as i64 + dy).clamp(0, height - 1);
        picture.pixels[(y * width + x) as usize].iter().map(|c| f64::from(*c)).sum::<f64>() / 3.0
    };
    let row = |dy| pixel(0, dy) * (1.0 - f.x) + pixel(1, dy) * f.x;
    row(0) * (1.0 - f.y) + row(1) * f.y
}
