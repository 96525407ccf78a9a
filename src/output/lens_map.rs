//! Files of lens maps: EXRs with the end of every path, which other programs read as well.
//!
//! The channels `R` and `G` are an ST map: the position in an equirectangular image where the first ray of each pixel reaches the sky, from
//! 0 to 1, from the bottom left corner to the top right one; `A` is 1 where it does. The ends of the first rays have the names of
//! [`END_VALUES`], and those of later samples and branches have a prefix, such as `s001b00.`. Channels that are 0 everywhere are left out.
//! Nothing is compressed: reading is then as fast as the disk, and floats of directions compress badly.

use std::collections::HashMap;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use ::exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, ImageAttributes, Layer as ExrLayer, LayerAttributes,
    ReadChannels, ReadLayers, SmallVec, Text, Vec2, WritableImage, read,
};
use ::exr::{error::Error as ExrError, meta::attribute::AttributeValue};
use glam::DVec3;

use super::band::{channels, components};
use super::{AtomicFile, OutputError};
use crate::program::LayerKind;
use crate::render::{Band, END_VALUES, LensMap, MapRound, Status};

/// The attribute that distinguishes a map from an image, with the version of its channels.
const CONTENTS: (&str, &str) = ("contents", "lens map 1");

/// Writes a map, with the layers and the metadata of its image.
///
/// # Errors
///
/// Returns an error if the file cannot be created ([`AtomicFile::create`]) or written.
pub fn write(path: &Path, map: &LensMap, layers: &Band, metadata: &[(String, String)]) -> Result<(), OutputError> {
    let mut file = AtomicFile::create(path)?;
    let text = |text: &str| Text::from_slice_unchecked(text.as_bytes());
    let mut all: SmallVec<[AnyChannel<FlatSamples>; 4]> = st_map(map).into_iter().collect();
    for (layer, plane) in &layers.layers {
        for (name, bytes) in channels(*layer).iter().zip(components(plane)) {
            let samples = if layer.kind() == LayerKind::Id {
                FlatSamples::U32(bytemuck::pod_collect_to_vec(bytes))
            } else {
                FlatSamples::F32(bytemuck::pod_collect_to_vec(bytes))
            };
            all.push(AnyChannel::new(*name, samples));
        }
    }
    for (i, round) in map.rounds.iter().enumerate() {
        let prefix = if i == 0 { String::new() } else { prefix(round.sample, round.branch) };
        for (value, plane) in END_VALUES.iter().zip(&round.planes).filter(|(_, plane)| !plane.is_empty()) {
            let samples = if value.is_whole {
                FlatSamples::U32(plane.clone())
            } else {
                FlatSamples::F32(bytemuck::cast_slice(plane).to_vec())
            };
            all.push(AnyChannel::new(text(&format!("{prefix}{}", value.channel)), samples));
        }
    }
    let [width, height] = map.size.map(|side| side as usize);
    let size = Vec2(width, height);
    let said = metadata.iter().map(|(key, value)| (key.as_str(), value.as_str())).chain([CONTENTS]);
    let other = said.map(|(key, value)| (text(key), AttributeValue::Text(text(value)))).collect();
    let layer = ExrLayer::new(size, LayerAttributes::default(), Encoding::UNCOMPRESSED, AnyChannels::sort(all));
    let attributes = ImageAttributes { other, ..ImageAttributes::with_size(size) };
    let written = Image::new(attributes, layer).write().to_buffered(&mut file);
    written.map_err(|error| failed(path, error))?;
    file.finish()
}

fn prefix(sample: u32, branch: u32) -> String {
    format!("s{sample:03}b{branch:02}.")
}

/// Returns the channels of the ST map.
fn st_map(map: &LensMap) -> [AnyChannel<FlatSamples>; 4] {
    let pixels = map.size.iter().map(|side| *side as usize).product();
    let status = map.plane("id.status");
    let v = ["direction.X", "direction.Y", "direction.Z"].map(|channel| map.plane(channel));
    let mut planes = [(); 4].map(|()| vec![0.0_f32; pixels]);
    for (pixel, code) in status.iter().enumerate() {
        if !matches!(Status::from_code(*code), Status::Escaped) {
            continue;
        }
        let component = |k: usize| v[k].get(pixel).map_or(0.0, |bits| f64::from(f32::from_bits(*bits)));
        let d = DVec3::new(component(0), component(1), component(2)).normalize_or_zero();
        planes[0][pixel] = (0.5 + d.x.atan2(-d.z) / std::f64::consts::TAU) as f32;
        planes[1][pixel] = (0.5 + d.y.clamp(-1.0, 1.0).asin() / std::f64::consts::PI) as f32;
        planes[3][pixel] = 1.0;
    }
    let [u, v, zero, alpha] = planes;
    [("R", u), ("G", v), ("B", zero), ("A", alpha)].map(|(name, plane)| AnyChannel::new(name, FlatSamples::F32(plane)))
}

/// Reads a map, and its metadata.
///
/// # Errors
///
/// Returns an error if the file cannot be read, or is not a map.
pub fn read_map(path: &Path) -> Result<(LensMap, Vec<(String, String)>), OutputError> {
    let file = File::open(path).map_err(|cause| OutputError::Read { path: path.to_owned(), cause })?;
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .from_buffered(BufReader::new(file))
        .map_err(|error| failed(path, error))?;
    let wrong = || OutputError::Part {
        path: path.to_owned(),
        problem: "it is not a lens map; `bentray map` writes one".to_owned(),
    };
    let metadata = image.attributes.other.iter().chain(&image.layer_data.attributes.other);
    let metadata = metadata.filter_map(|(key, value)| match value {
        AttributeValue::Text(text) => {
            let utf8 = |text: &Text| String::from_utf8(text.as_slice().to_vec()).ok();
            Some((utf8(key)?, utf8(text)?))
        }
        _ => None,
    });
    let mut metadata: Vec<(String, String)> = metadata.collect();
    let contents = metadata.iter().position(|(key, text)| (key.as_str(), text.as_str()) == CONTENTS);
    metadata.swap_remove(contents.ok_or_else(wrong)?);
    let Vec2(width, height) = image.layer_data.size;
    let pixels = width * height;
    let size = [width, height].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    let mut found: HashMap<String, FlatSamples> = HashMap::new();
    for channel in image.layer_data.channel_data.list {
        found.insert(channel.name.to_string(), channel.sample_data);
    }
    let mut keys: Vec<(u32, u32)> = found.keys().filter_map(|name| sample_and_branch(name)).collect();
    keys.sort_unstable();
    keys.dedup();
    let mut take = |name: &str| match found.remove(name) {
        Some(FlatSamples::F32(values)) => bytemuck::cast_vec(values),
        Some(FlatSamples::U32(values)) => values,
        _ => Vec::new(),
    };
    let mut planes = |prefix: &str| -> Vec<Vec<u32>> {
        END_VALUES.iter().map(|value| take(&format!("{prefix}{}", value.channel))).collect()
    };
    let first = MapRound { sample: 0, branch: 0, planes: planes("") };
    let later = keys.into_iter().map(|(sample, branch)| {
        let planes = planes(&prefix(sample, branch));
        MapRound { sample, branch, planes }
    });
    let map = LensMap { size, rounds: std::iter::once(first).chain(later).collect() };
    let is_whole = |plane: &Vec<u32>| plane.is_empty() || plane.len() == pixels;
    if map.plane("id.status").is_empty() || !map.rounds.iter().flat_map(|round| &round.planes).all(is_whole) {
        return Err(wrong());
    }
    Ok((map, metadata))
}

/// Returns the sample and the branch of a channel with a prefix.
fn sample_and_branch(name: &str) -> Option<(u32, u32)> {
    let (sample, branch) = name.split_once('.')?.0.strip_prefix('s')?.split_once('b')?;
    Some((sample.parse().ok()?, branch.parse().ok()?))
}

fn failed(path: &Path, error: ExrError) -> OutputError {
    match error {
        ExrError::Io(cause) => OutputError::Write { path: path.to_owned(), cause },
        other => OutputError::Encode { path: path.to_owned(), problem: other.to_string() },
    }
}
