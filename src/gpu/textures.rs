//! Uploads the textures of a scene.

use std::borrow::Cow;

use half::f16;
use half::slice::HalfFloatSliceExt;
use rayon::prelude::*;
use wgpu::{
    Extent3d, Origin3d, TexelCopyBufferLayout, TexelCopyTextureInfo, Texture, TextureDescriptor, TextureDimension,
    TextureFormat, TextureUsages,
};

use super::{Gpu, GpuError};
use crate::scene::{Picture, Scene};

/// The number of pixels that are converted and written at once.
const BAND: u32 = 1 << 20;
/// The number of pixels that one task converts.
const SHARE: usize = 1 << 14;

/// Returns the size at which a device stores an image, if its textures have sides of up to `most` pixels: the size is halved until the
/// image fits, together with its reduced copies if it is `averaged`.
fn held_size(mut size: [u32; 2], averaged: bool, most: u32) -> [u32; 2] {
    let fits = |[width, height]: [u32; 2]| {
        let below = if averaged { height / 2 } else { 0 };
        width <= most && height.saturating_add(below) <= most
    };
    while !fits(size) && size != [1, 1] {
        size = halved(size);
    }
    size
}

fn halved(size: [u32; 2]) -> [u32; 2] {
    size.map(|side| (side / 2).max(1))
}

/// Returns a warning for each image of a scene that is larger than the device's textures, whose sides have up to `most` pixels; the warning
/// names the size that is used instead.
#[must_use]
pub fn halved_pictures(scene: &Scene, most: u32) -> Vec<String> {
    let words = |picture: &Picture| {
        let ([width, height], [less_wide, less_high]) =
            (picture.size, held_size(picture.size, scene.has_footprints(), most));
        (picture.size != [less_wide, less_high]).then(|| {
            format!(
                "`{}` has {width}×{height} pixels, more than the device's limit of {most} per side, and is reduced \
                 to {less_wide}×{less_high}",
                picture.name
            )
        })
    };
    scene.pictures.iter().filter_map(words).collect()
}

/// Uploads an image, in 16 bits if its values fit, and halved until the device can hold it. If it is to be averaged, successively halved
/// copies are stored below it, in the layout of `surface/image_filtered`.
pub(super) fn upload_picture(gpu: &Gpu, picture: &Picture, averaged: bool) -> Result<Texture, GpuError> {
    let most = gpu.limits.max_texture_dimension_2d;
    let size = held_size(picture.size, averaged, most);
    let mut level = Level { size: picture.size, pixels: Cow::Borrowed(&picture.pixels[..]) };
    while level.size != size {
        level = level.halved();
    }
    let [width, picture_height] = size;
    let height = if averaged { picture_height + picture_height / 2 } else { picture_height };
    let what = format!("pixels along one side of an image (`{}`)", picture.name);
    gpu.check("max_texture_dimension_2d", &what, u64::from(most), u64::from(width.max(height)))?;
    let halves = picture.pixels.iter().flatten().all(|v| *v <= f16::MAX.to_f32());
    let format = if halves { TextureFormat::Rgba16Float } else { TextureFormat::Rgba32Float };
    let texture = gpu.device.create_texture(&TextureDescriptor {
        label: Some(&picture.name),
        size: Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
        view_formats: &[],
    });
    write(gpu, &texture, [0, 0], &level, halves);
    let copies = if averaged { width.min(picture_height).ilog2() } else { 0 };
    for copy in 0..copies {
        level = level.halved();
        write(gpu, &texture, [width - (width >> copy), picture_height], &level, halves);
    }
    Ok(texture)
}

fn write(gpu: &Gpu, texture: &Texture, [x, y]: [u32; 2], Level { size: [width, _], pixels }: &Level, halves: bool) {
    let rows = (BAND / width).max(1);
    for (k, pixels) in pixels.chunks((rows * width) as usize).enumerate() {
        let bytes = texels(pixels, halves);
        let size = Extent3d { width: *width, height: pixels.len() as u32 / width, depth_or_array_layers: 1 };
        let origin = Origin3d { x, y: y + k as u32 * rows, z: 0 };
        let row = TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(bytes.len() as u32 / size.height),
            rows_per_image: None,
        };
        gpu.queue.write_texture(TexelCopyTextureInfo { origin, ..texture.as_image_copy() }, &bytes, row, size);
        // Submit at once, because written data stays in host memory until then.
        gpu.queue.submit([]);
    }
}

/// An image, or a reduced copy of it.
struct Level<'p> {
    size: [u32; 2],
    pixels: Cow<'p, [[f32; 3]]>,
}

impl Level<'_> {
    /// Returns a copy of half the width and height, rounded down. Each pixel is the mean of the pixels that it covers, so the overall mean
    /// is unchanged.
    fn halved(&self) -> Level<'static> {
        let [width, height] = self.size;
        let size = halved(self.size);
        let row = |y: u32| -> Vec<[f32; 3]> {
            let pixel = |x: u32| {
                let mut sum = [0.0; 3];
                for (j, wy) in covered(height, size[1], y) {
                    for (i, wx) in covered(width, size[0], x) {
                        let from = self.pixels[j as usize * width as usize + i as usize];
                        sum.iter_mut().zip(from).for_each(|(sum, value)| *sum += wx * wy * value);
                    }
                }
                sum
            };
            (0..size[0]).map(pixel).collect()
        };
        let pixels: Vec<_> = (0..size[1]).into_par_iter().flat_map_iter(row).collect();
        Level { size, pixels: pixels.into() }
    }
}

/// Returns the pixels that one of `parts` equal parts of a side covers, each with its share of the part.
fn covered(side: u32, parts: u32, part: u32) -> impl Iterator<Item = (u32, f32)> {
    let [side, parts, part] = [side, parts, part].map(u64::from);
    // Lengths are in units of 1/`parts` of a pixel.
    let (begin, end) = (part * side, (part + 1) * side);
    (begin / parts..end.div_ceil(parts)).map(move |pixel| {
        let pieces = end.min((pixel + 1) * parts) - begin.max(pixel * parts);
        (pixel as u32, (pieces as f64 / side as f64) as f32)
    })
}

/// Returns the bytes of opaque texels, converted on all cores.
fn texels(pixels: &[[f32; 3]], halves: bool) -> Vec<u8> {
    let bytes = 4 * if halves { size_of::<f16>() } else { size_of::<f32>() };
    let mut all = vec![0; pixels.len() * bytes];
    all.par_chunks_mut(SHARE * bytes).zip(pixels.par_chunks(SHARE)).for_each(|(out, pixels)| {
        let texels: Vec<[f32; 4]> = pixels.iter().map(|[r, g, b]| [*r, *g, *b, 1.0]).collect();
        if halves {
            let mut halved = vec![f16::ZERO; 4 * texels.len()];
            halved.convert_from_f32_slice(texels.as_flattened());
            out.copy_from_slice(bytemuck::cast_slice(&halved));
        } else {
            out.copy_from_slice(bytemuck::cast_slice(&texels));
        }
    });
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn pictures_are_halved_until_they_fit() {
        assert_eq!(held_size([16384, 8192], false, 16384), [16384, 8192]);
        assert_eq!(held_size([16385, 8193], false, 16384), [8192, 4096]);
        assert_eq!(held_size([70_000, 35_000], false, 16384), [8750, 4375]);
        // The height is one and a half times as large with the reduced copies.
        assert_eq!(held_size([10_000, 12_000], true, 16384), [5000, 6000]);
        assert_eq!(held_size([40, 10_922], true, 16384), [40, 10_922]);
        assert_eq!(held_size([1, 100_000], false, 16384), [1, 12_500]);
    }

    proptest! {
        /// Checks that, for any odd sides, each copy has the mean of the image, and an image of one color keeps it.
        #[test]
        fn smaller_copies_keep_the_mean(width in 1_u32..70, height in 1_u32..70, seed in 0_u32..1000) {
            let value = |i: u32| ((i.wrapping_mul(2_654_435_761).wrapping_add(seed)) >> 16) as f32 / 65_536.0;
            let pixels: Vec<[f32; 3]> = (0..width * height).map(|i| [value(i), 0.25, value(3 * i + 1)]).collect();
            let mean = |pixels: &[[f32; 3]], k: usize| {
                pixels.iter().map(|pixel| f64::from(pixel[k])).sum::<f64>() / pixels.len() as f64
            };
            let mut level = Level { size: [width, height], pixels: Cow::Borrowed(&pixels[..]) };
            while level.size != [1, 1] {
                level = level.halved();
                for k in 0..3 {
                    // Sums of up to nine values in float32, seven times over.
                    prop_assert!((mean(&level.pixels, k) - mean(&pixels, k)).abs() < 1e-5, "{:?}", level.size);
                }
                prop_assert!(level.pixels.iter().all(|pixel| (pixel[1] - 0.25).abs() < 1e-6));
            }
        }
    }
}
