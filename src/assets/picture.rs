//! Pictures: PNG, JPEG, EXR and HDR files as linear RGB.
//!
//! *Theory.* Light adds up only in linear units. PNG and JPEG store sRGB, whose curve is undone here; EXR and HDR are linear.
//!
//! *Practice.* The format is told by the file's content. Alpha is dropped, grey becomes RGB, and 16 bits carry both
//! depths of PNG without loss. 12 bytes a pixel stay in memory.

use crate::document::SceneError;
use exr::meta::MetaData;
use exr::meta::header::Header;
use image::codecs::hdr::HdrDecoder;
use image::{DynamicImage, ImageFormat, ImageReader, ImageResult};
use std::fs::File;
use std::io::BufReader;
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
    /// Reads a PNG, JPEG, EXR or HDR file.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let unreadable = |source| SceneError::Read { path: path.to_owned(), source };
        let unusable = |problem: String| SceneError::Picture { path: path.to_owned(), problem };
        let open = || ImageReader::open(path).and_then(ImageReader::with_guessed_format).map_err(unreadable);
        let mut reader = open()?;
        // Films are written by the same library, so it reads GIF as well, whose frames may be larger than its header says.
        let Some(format) = reader.format().filter(|format| FORMATS.contains(format)) else {
            return Err(unusable("its content is that of no PNG, JPEG, EXR or HDR file: convert it to one".to_owned()));
        };
        let (width, height) = open()?.into_dimensions().map_err(|e| unusable(e.to_string()))?;
        let size = [width, height];
        let bytes = std::fs::metadata(path).map_err(unreadable)?.len();
        if let Some(problem) = unlikely(size, bytes) {
            return Err(unusable(problem));
        }
        if format == ImageFormat::OpenExr {
            let read = MetaData::read_from_file(path, false).map_err(|e| unusable(e.to_string()))?;
            if let Some(problem) = read.headers.iter().find_map(|header| unlikely_exr(header, bytes)) {
                return Err(unusable(problem));
            }
        }
        // By default a picture over 512 MiB is refused; a sky may well be larger.
        reader.no_limits();
        let exposure = exposure(path, format).map_err(|e| unusable(e.to_string()))?;
        let image = reader.decode().map_err(|e| unusable(e.to_string()))?;
        let mut pixels = linear(image);
        pixels.iter_mut().flatten().for_each(|value| *value /= exposure);
        let broken = |pixel: &[f32; 3]| pixel.iter().any(|x| !x.is_finite());
        if let Some(index) = pixels.iter().position(broken) {
            let (x, y) = (index % size[0] as usize, index / size[0] as usize);
            return Err(unusable(format!("the pixel in column {x}, row {y} (from 0, top left) is not finite")));
        }
        Ok(Self { size, pixels: Arc::new(pixels), name: path.display().to_string() })
    }
}

impl Picture {
    /// What a file's header says that [`load`](Self::load) takes of memory; 0 where that cannot be so.
    #[must_use]
    pub fn bytes_of(path: &Path) -> u64 {
        let open = || ImageReader::open(path).and_then(ImageReader::with_guessed_format).ok();
        let Some((width, height)) = open().and_then(|reader| reader.into_dimensions().ok()) else { return 0 };
        let is_likely = std::fs::metadata(path).is_ok_and(|file| unlikely([width, height], file.len()).is_none());
        if is_likely { u64::from(width) * u64::from(height) * BYTES } else { 0 }
    }

    /// What it takes of memory.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.pixels.len() as u64 * BYTES
    }
}

/// Of a pixel.
const BYTES: u64 = size_of::<[f32; 3]>() as u64;

/// What is read.
const FORMATS: [ImageFormat; 4] = [ImageFormat::Png, ImageFormat::Jpeg, ImageFormat::OpenExr, ImageFormat::Hdr];
/// Pixels that a picture may have: 3 GiB of memory.
const MOST_PIXELS: u64 = 1 << 28;
/// Pixels that a byte of a file stands for at most, by any of the formats: their best compression is near 1000.
const DENSEST: u64 = 4096;

/// Why nothing should be read of a picture of this size from so many bytes.
fn unlikely([width, height]: [u32; 2], bytes: u64) -> Option<String> {
    let pixels = u64::from(width) * u64::from(height);
    if pixels == 0 {
        Some("it has no pixels".to_owned())
    } else if pixels / DENSEST > bytes {
        Some(format!("its header says {width}×{height} pixels, which its {bytes} bytes cannot hold"))
    } else if pixels > MOST_PIXELS {
        Some(format!("it has {width}×{height} pixels, {pixels}, and at most {MOST_PIXELS} are read: make it smaller"))
    } else {
        None
    }
}

/// Bytes of an EXR's samples that a byte of its file stands for at most.
const DENSEST_EXR: u64 = 4 * DENSEST;

/// The same of a layer of an EXR, which may be of another size than the picture.
pub(crate) fn unlikely_exr(header: &Header, bytes: u64) -> Option<String> {
    let (width, height) = (header.layer_size.0 as u64, header.layer_size.1 as u64);
    let each = header.channels.bytes_per_pixel as u64;
    let all = width.saturating_mul(height).saturating_mul(each);
    let problem = || {
        format!(
            "its header says a layer of {width}×{height} pixels of {each} bytes, which its {bytes} bytes cannot hold"
        )
    };
    (all / DENSEST_EXR > bytes).then(problem)
}

/// What an HDR file's numbers are to be divided by to be radiance; 1 for others.
fn exposure(path: &Path, format: ImageFormat) -> ImageResult<f32> {
    if format != ImageFormat::Hdr {
        return Ok(1.0);
    }
    let header = HdrDecoder::new(BufReader::new(File::open(path)?))?.metadata();
    Ok(header.exposure.filter(|exposure| exposure.is_normal() && *exposure > 0.0).unwrap_or(1.0))
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
