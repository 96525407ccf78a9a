//! A reader of all planes of an image from an EXR that [`exr`](super::exr) wrote.

use std::collections::BTreeMap;
use std::path::Path;

use super::band::{channel_names, channels as channels_of};
use super::part::ImagePart;
use super::{FileSettings, OutputError};
use crate::program::LayerKind;
use crate::render::{Band, Plane};

/// Returns the settings and contents of the EXR at `path`.
///
/// # Errors
///
/// Returns an error if the file cannot be read, or is not an image that `render` wrote.
pub fn picture(path: &Path) -> Result<(FileSettings, Band), OutputError> {
    let mut part = ImagePart::open(path)?;
    let [width, rows] = part.settings.window.size;
    let settings = part.settings.clone();
    let names = channel_names(&settings);
    let mut planes: BTreeMap<&str, Vec<u32>> = names.iter().map(|name| (*name, Vec::new())).collect();
    for _ in 0..rows {
        let row = part.next_row()?;
        for (name, samples) in names.iter().zip(row.chunks_exact(size_of::<u32>() * width as usize)) {
            let words: Vec<u32> = bytemuck::pod_collect_to_vec(samples);
            planes.entry(name).or_default().extend(words);
        }
    }
    let band = band_of(&settings, planes, [0, rows]);
    Ok((settings, band))
}

/// Returns a band of these rows, from the bits of each channel.
pub(super) fn band_of(
    settings: &FileSettings,
    mut planes: BTreeMap<&str, Vec<u32>>,
    [first_row, rows]: [u32; 2],
) -> Band {
    let mut floats = |name: &str| -> Vec<f32> { bytemuck::cast_vec(planes.remove(name).unwrap_or_default()) };
    let color = ["R", "G", "B"].map(&mut floats);
    let alpha = settings.alpha.then(|| floats("A"));
    let mut plane = |layer| match channels_of(layer) {
        [name] if layer.kind() == LayerKind::Id => Plane::Id(bytemuck::cast_vec(floats(name))),
        [x, y, z] => Plane::Vector([x, y, z].map(|name| floats(name))),
        [a, b, c, d] => Plane::Crossings([a, b, c, d].map(|name| floats(name))),
        names => Plane::Scalar(names.first().map(|name| floats(name)).unwrap_or_default()),
    };
    let layers = settings.layers.iter().map(|layer| (*layer, plane(*layer))).collect();
    Band { first_row, rows, width: settings.window.size[0], color, alpha, layers }
}
