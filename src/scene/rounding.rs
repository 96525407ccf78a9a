//! Warnings about scenes for which 32 bits are too coarse, because objects are small relative to their position or pixels are finer than
//! directions.
//!
//! *Theory.* A coordinate x has an error of 2⁻²⁴ |x|. A ray is as accurate as the coarsest positions of its computation, the camera's and
//! the object's. The error is visible if it is a large fraction of the object or of a pixel's footprint. Larger errors of methods are
//! measured elsewhere; if paths are straight or have a closed form, rounding is the only error.
//!
//! *Practice.* The host computes a few products per object. The result is a warning instead of an error, because parts of such an image may
//! be correct.

use super::{Picture, Precision, Scene};

/// The relative half unit in the last place of 32 bits.
const HALF_ULP: f64 = 1.0 / 16_777_216.0;
/// The number of roundings that add up along a ray to a surface.
const ROUNDINGS: f64 = 4.0;
/// The fraction of an object that may be lost.
const OF_OBJECT: f64 = 0.01;
/// The fraction of a pixel that may be lost.
const OF_PIXEL: f64 = 0.5;
/// The largest number of objects in a message.
const NAMED: usize = 3;

impl Scene {
    /// Returns messages about differences of the image from the scene and its files.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let of_picture = |picture: &Picture| {
            let name = picture.name.clone();
            picture.notes.clone().into_iter().map(move |note| format!("{name}: {note}"))
        };
        self.left_out
            .iter()
            .cloned()
            .chain(self.rounded_away())
            .chain(self.impossible_matter())
            .chain(self.pictures.iter().flat_map(of_picture))
            .chain(self.stars.iter().flatten().filter_map(|stars| stars.catalog.warning()))
            .collect()
    }

    /// Returns a message about details that 32 bits cannot resolve, or `None` if they suffice or the scene uses more.
    #[must_use]
    pub fn rounded_away(&self) -> Option<String> {
        if self.rays.precision == Precision::Double {
            return None;
        }
        let camera = self.camera.as_ref()?;
        let pixel = self.pixel_angle();
        if let Some(pixel) = pixel.filter(|pixel| ROUNDINGS * HALF_ULP > OF_PIXEL * pixel) {
            return Some(format!(
                "a pixel is {pixel:.0e} rad wide, and the resolution of 32-bit directions is {:.0e}: use --precision \
                 f64",
                2.0 * HALF_ULP
            ));
        }
        let too_coarse = |i: &usize| {
            let (center, radius) = self.objects[*i].ball();
            let known = HALF_ULP * camera.position.abs().max_element().max(center.abs().max_element());
            let distance = (camera.position.distance(center) - radius).max(radius);
            let seen = pixel.map_or(f64::INFINITY, |pixel| pixel * distance);
            radius.is_finite() && ROUNDINGS * known > (OF_OBJECT * radius).min(OF_PIXEL * seen)
        };
        let coarse: Vec<usize> = (0..self.objects.len()).filter(too_coarse).collect();
        let names: Vec<String> = coarse.iter().take(NAMED).map(|i| format!("objects[{i}]")).collect();
        let (first, more) = (coarse.first()?, coarse.len() > NAMED);
        let (center, radius) = self.objects[*first].ball();
        let far = camera.position.abs().max_element().max(center.abs().max_element());
        Some(format!(
            "{}{}: at {far:.0e} from the origin, 32-bit positions are {:.0e} apart, and objects[{first}] is {:.0e} \
             across; \
             move the scene to the origin, reduce its range of scales, or use --precision f64",
            names.join(", "),
            if more { ", …" } else { "" },
            2.0 * HALF_ULP * far,
            2.0 * radius,
        ))
    }
}
