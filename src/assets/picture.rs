//! Pictures: PNG, EXR and HDR files as linear RGB.
//!
//! *Theory.* Light adds up only in linear units. PNG stores sRGB, whose curve is undone here; EXR and HDR are linear.
//!
//! *Practice.* The format is told by the file's content. Alpha is dropped, grey becomes RGB, and 16 bits carry both
//! depths of PNG without loss. 12 bytes a pixel stay in memory.

use crate::document::SceneError;
use image::{DynamicImage, ImageReader};
use std::path::Path;
use std::sync::Arc;

/// A picture in linear RGB.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Rows from the top, each from the left; every number is finite. Copies of a scene share them.
    pub pixels: Arc<Vec<[f32; 3]>>,
    /// The path it was read from.
    pub name: String,
}

impl Picture {
    /// Reads a PNG, EXR or HDR file.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let unreadable = |source| SceneError::Read { path: path.to_owned(), source };
        let unusable = |problem: String| SceneError::Picture { path: path.to_owned(), problem };
        let reader = ImageReader::open(path).map_err(unreadable)?;
        let mut reader = reader.with_guessed_format().map_err(unreadable)?;
        // By default a picture over 512 MiB is refused; a sky may well be larger.
        reader.no_limits();
        let image = reader.decode().map_err(|e| unusable(e.to_string()))?;
        let size = [image.width(), image.height()];
        if size.contains(&0) {
            return Err(unusable("it has no pixels".to_owned()));
        }
        let pixels = linear(image);
        let broken = |pixel: &[f32; 3]| pixel.iter().any(|x| !x.is_finite());
        if let Some(index) = pixels.iter().position(broken) {
            let (x, y) = (index % size[0] as usize, index / size[0] as usize);
            return Err(unusable(format!("the pixel in column {x}, row {y} (from 0, top left) is not finite")));
        }
        Ok(Self { size, pixels: Arc::new(pixels), name: path.display().to_string() })
    }
}

fn linear(image: DynamicImage) -> Vec<[f32; 3]> {
    match image {
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_) => {
            image.into_rgb32f().pixels().map(|pixel| pixel.0).collect()
        }
        _ if image.color().bytes_per_pixel() == image.color().channel_count() => {
            // 8 bits are 16 with both bytes the same.
            let curve: Vec<f32> = (0..=u8::MAX).map(|x| decode_srgb(u16::from(x) * 257)).collect();
            image.into_rgb8().pixels().map(|pixel| pixel.0.map(|x| curve[usize::from(x)])).collect()
        }
        _ => {
            let curve: Vec<f32> = (0..=u16::MAX).map(decode_srgb).collect();
            let rgb = image.into_rgb16();
            let pixels = rgb.pixels();
            pixels.map(|pixel| pixel.0.map(|x| curve[usize::from(x)])).collect()
        }
    }
}

/// IEC 61966-2-1.
fn decode_srgb(x: u16) -> f32 {
    let x = f64::from(x) / 65_535.0;
    let linear = if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) };
    linear as f32
}
