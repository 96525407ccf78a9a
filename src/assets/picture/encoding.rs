//! Encodings: the meaning of the numbers in an image file, as far as the file specifies it.
//!
//! *Theory.* A curve for each channel undoes the encoding of integers, and a matrix converts the primaries to those of Rec. 709. Colors
//! outside the gamut of Rec. 709 have a negative component, which is set to 0, as for black bodies: no light is negative.

use glam::{DMat3, DVec3, Vec3};
use image::DynamicImage;
use moxcms::{ColorProfile, DataColorSpace, ToneReprCurve};
use rayon::prelude::*;

use super::primaries::{Primaries, profile_to_rec709};

/// A function from a stored number to linear light, both from 0 to 1.
pub(super) type Curve = Box<dyn Fn(f64) -> f64>;

/// The color encoding of a file.
pub(super) struct Encoding {
    /// The curves of red, green and blue.
    pub curves: [Curve; 3],
    /// The matrix from linear colors to Rec. 709.
    pub to_rec709: DMat3,
    /// The color information in the file that is not applied, as messages.
    pub notes: Vec<String>,
}

impl Default for Encoding {
    /// Returns sRGB, the default for files without color information.
    fn default() -> Self {
        Self::new(|| Box::new(decode_srgb), DMat3::IDENTITY)
    }
}

impl Encoding {
    pub fn new(curve: impl Fn() -> Curve, to_rec709: DMat3) -> Self {
        Self { curves: [curve(), curve(), curve()], to_rec709, notes: Vec::new() }
    }

    /// Returns sRGB, with a note about information that is not applied.
    pub fn unapplied(note: String) -> Self {
        Self { notes: vec![note], ..Self::default() }
    }

    /// Reads an ICC profile, which is applied if it consists of curves and a matrix.
    pub fn of_profile(bytes: &[u8]) -> Self {
        Self::of_matrix_profile(bytes).unwrap_or_else(|why| {
            Self::unapplied(format!("the ICC profile is ignored, because {why}: convert the image to sRGB"))
        })
    }

    fn of_matrix_profile(bytes: &[u8]) -> Result<Self, String> {
        let profile = ColorProfile::new_from_slice(bytes).map_err(|error| format!("it cannot be read ({error})"))?;
        if profile.pcs != DataColorSpace::Xyz {
            return Err("it has tables instead of a matrix".to_owned());
        }
        let (curves, to_xyz) = match profile.color_space {
            DataColorSpace::Rgb => ([&profile.red_trc, &profile.green_trc, &profile.blue_trc], {
                let columns = [profile.red_colorant, profile.green_colorant, profile.blue_colorant];
                let [red, green, blue] = columns.map(|c| DVec3::new(c.x, c.y, c.z));
                DMat3::from_cols(red, green, blue)
            }),
            DataColorSpace::Gray => ([&profile.gray_trc; 3], DMat3::ZERO),
            other => return Err(format!("it is for {other:?}")),
        };
        let curve = |curve: &Option<ToneReprCurve>| -> Option<Curve> {
            let curve = curve.as_ref()?.make_linear_evaluator().ok()?;
            Some(Box::new(move |x| f64::from(curve.evaluate_value(x as f32))))
        };
        let [Some(red), Some(green), Some(blue)] = curves.map(curve) else {
            return Err("it has no curves".to_owned());
        };
        let to_rec709 = match profile.color_space {
            DataColorSpace::Gray => Some(DMat3::IDENTITY),
            _ => profile_to_rec709().map(|from_xyz| from_xyz * to_xyz),
        };
        let to_rec709 = to_rec709.filter(|matrix| matrix.is_finite() && matrix.determinant().abs() > 1e-6);
        let to_rec709 = to_rec709.ok_or("its colors do not span a color space")?;
        Ok(Self { curves: [red, green, blue], to_rec709: near_identity(to_rec709), notes: Vec::new() })
    }

    /// Returns the linear colors of an image of integers.
    pub fn decode(&self, image: DynamicImage) -> Vec<[f32; 3]> {
        let has_bytes = image.color().bytes_per_pixel() == image.color().channel_count();
        let most = if has_bytes { u32::from(u8::MAX) } else { u32::from(u16::MAX) };
        let table = |curve: &Curve| (0..=most).map(|x| curve(f64::from(x) / f64::from(most)) as f32).collect();
        let [red, green, blue]: [Vec<f32>; 3] = self.curves.each_ref().map(table);
        let color = |[r, g, b]: [usize; 3]| [red[r], green[g], blue[b]];
        if has_bytes {
            image.into_rgb8().pixels().map(|pixel| color(pixel.0.map(usize::from))).collect()
        } else {
            image.into_rgb16().pixels().map(|pixel| color(pixel.0.map(usize::from))).collect()
        }
    }
}

/// Returns the identity for a matrix close to it, because the rounding of a profile's 16-bit numbers must not tint gray.
fn near_identity(matrix: DMat3) -> DMat3 {
    if matrix.abs_diff_eq(DMat3::IDENTITY, 1e-3) { DMat3::IDENTITY } else { matrix }
}

/// Converts colors to Rec. 709, and returns a note if some are outside its gamut.
pub(super) fn convert(pixels: &mut [[f32; 3]], to_rec709: DMat3) -> Option<String> {
    /// The largest negative component that is due to rounding.
    const ROUNDING: f64 = 1e-5;
    if to_rec709 == DMat3::IDENTITY {
        return None;
    }
    let convert = |pixel: &mut [f32; 3]| {
        let given = Vec3::from(*pixel).as_dvec3();
        let color = to_rec709 * given;
        let lowest = given.min_element().min(0.0);
        *pixel = color.max(DVec3::splat(lowest)).as_vec3().into();
        usize::from(color.min_element() < lowest - ROUNDING * color.abs().max_element())
    };
    let outside: usize = pixels.par_iter_mut().map(convert).sum();
    let count = pixels.len();
    let share = 100.0 * outside as f64 / count.max(1) as f64;
    (outside > 0).then(|| {
        format!(
            "{outside} of its {count} pixels ({share:.2} %) have colors outside of Rec. 709, whose negative \
             components are set to 0"
        )
    })
}

/// Returns the matrix of the primaries in a file, or a note that they are not applied.
pub(super) fn matrix_of(primaries: Primaries, named: &str) -> Result<DMat3, String> {
    primaries.to_rec709().ok_or_else(|| format!("the {named} are ignored, because they do not span a color space"))
}

/// Decodes sRGB according to IEC 61966-2-1.
pub(in crate::assets) fn decode_srgb(x: f64) -> f64 {
    if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}
