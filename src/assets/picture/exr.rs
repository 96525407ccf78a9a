//! EXR: linear colors in named channels.
//!
//! *Practice.* The reader uses `R`, `G` and `B`, or `Y` for gray images, in either case; if the file has no such
//! channels, it uses those of a layer (`ViewLayer.Combined.R`). Of several such layers it prefers `Combined`, which
//! is the whole image in Blender's files. `chromaticities` are applied. Pixels outside the data window are black.

use std::collections::BTreeMap;
use std::path::Path;

use exr::error::Error;
use exr::image::read::layers::ReadChannels;
use exr::image::read::specific_channels::ReadSpecificChannel;
use exr::math::Vec2;
use exr::meta::MetaData;
use exr::meta::attribute::{ChannelDescription, Chromaticities, IntegerBounds, Text};
use exr::meta::header::Header;
use exr::prelude::{ReadLayers, read};

use super::broken::broken;
use super::encoding::{convert, matrix_of};
use super::primaries::Primaries;
use super::{DENSEST, Decoded};
use crate::progress::Stage;

/// The first bytes of every file.
pub(super) const MAGIC: &[u8] = b"\x76\x2f\x31\x01";

/// The channels that are read.
enum Channels {
    Rgb([Text; 3]),
    Gray(Text),
}

/// Reads the width and height from a file's header.
pub(super) fn size(path: &Path) -> Result<[u32; 2], String> {
    let meta = meta(path)?;
    let size = display_window(meta.headers.first().ok_or("the file has no header")?).size;
    Ok([size.width() as u32, size.height() as u32])
}

/// Reads a file of `bytes` bytes, and advances `stage` by that amount in total.
pub(super) fn read_file(path: &Path, bytes: u64, stage: &Stage) -> Result<Decoded, String> {
    let headers = meta(path)?.headers;
    if let Some(problem) = headers.iter().find_map(|header| unlikely(header, bytes)) {
        return Err(problem);
    }
    let header = headers.first().ok_or("the file has no header")?;
    let window = display_window(header);
    let progress = |done: f64| stage.reach(done * bytes as f64);
    let mut pixels = match channels(&headers)? {
        Channels::Rgb(names) => rgb(path, names, window, progress),
        Channels::Gray(name) => gray(path, name, window, progress),
    }
    .map_err(|error| broken(&error))?;
    let mut notes = Vec::new();
    if let Some(named) = &header.shared_attributes.chromaticities {
        match matrix_of(primaries(named), "chromaticities") {
            Ok(to_rec709) => notes.extend(convert(&mut pixels, to_rec709)),
            Err(note) => notes.push(note),
        }
    }
    Ok(Decoded { pixels, notes })
}

fn meta(path: &Path) -> Result<MetaData, String> {
    MetaData::read_from_file(path, false).map_err(|error| broken(&error))
}

fn display_window(header: &Header) -> IntegerBounds {
    header.shared_attributes.display_window
}

fn primaries(named: &Chromaticities) -> Primaries {
    let Chromaticities { red, green, blue, white } = named;
    let [red, green, blue, white] = [red, green, blue, white].map(|c| [f64::from(c.x()), f64::from(c.y())]);
    Primaries::of([red[0], red[1], green[0], green[1], blue[0], blue[1], white[0], white[1]])
}

/// Chooses among the channels of all layers.
fn channels(headers: &[Header]) -> Result<Channels, String> {
    let flat = headers.iter().filter(|header| !header.deep);
    let mut layers: BTreeMap<String, Vec<&ChannelDescription>> = BTreeMap::new();
    for channel in flat.flat_map(|header| &header.channels.list) {
        let name = channel.name.to_string();
        let layer = name.rsplit_once('.').map_or("", |(layer, _)| layer);
        layers.entry(layer.to_owned()).or_default().push(channel);
    }
    let own = layers.remove("").unwrap_or_default();
    let of_layers = |find: &dyn Fn(&[&ChannelDescription]) -> Option<Channels>| {
        let mut found: Vec<(&str, Channels)> =
            layers.iter().filter_map(|(name, channels)| Some((name.as_str(), find(channels)?))).collect();
        if found.len() > 1 {
            let is_whole =
                |name: &str| name.rsplit('.').next().is_some_and(|last| last.eq_ignore_ascii_case("combined"));
            found.retain(|(name, _)| is_whole(name));
        }
        if found.len() == 1 { found.pop().map(|(_, channels)| channels) } else { None }
    };
    let found = rgb_of(&own).or_else(|| gray_of(&own)).or_else(|| of_layers(&|all| rgb_of(all)));
    found.or_else(|| of_layers(&|all| gray_of(all))).ok_or_else(|| refusal(headers))
}

/// Finds a channel by its name after the layer's name, case-sensitively first.
fn find(channels: &[&ChannelDescription], name: &str) -> Option<Text> {
    let own = |channel: &ChannelDescription| {
        let name = channel.name.to_string();
        name.rsplit_once('.').map_or(name.clone(), |(_, own)| own.to_owned())
    };
    let whole: Vec<_> = channels.iter().filter(|channel| channel.sampling == Vec2(1, 1)).collect();
    let exact = whole.iter().find(|channel| own(channel) == name);
    let found = exact.or_else(|| whole.iter().find(|channel| own(channel).eq_ignore_ascii_case(name)))?;
    Some(found.name.clone())
}

fn rgb_of(channels: &[&ChannelDescription]) -> Option<Channels> {
    Some(Channels::Rgb([find(channels, "R")?, find(channels, "G")?, find(channels, "B")?]))
}

/// Returns the channel of luminance alone: next to chroma it is only a component, and next to X or Z it is a coordinate.
fn gray_of(channels: &[&ChannelDescription]) -> Option<Channels> {
    let with_more = ["RY", "BY", "X", "Z"].iter().any(|name| find(channels, name).is_some());
    let is_whole = channels.iter().all(|channel| channel.sampling == Vec2(1, 1));
    find(channels, "Y").filter(|_| !with_more && is_whole).map(Channels::Gray)
}

/// Returns an error message that lists the channels in the file, and the supported ones.
fn refusal(headers: &[Header]) -> String {
    /// The largest number of names in the message.
    const LISTED: usize = 24;
    if headers.iter().all(|header| header.deep) {
        return "deep images are not supported: flatten the image first".to_owned();
    }
    let all = || headers.iter().filter(|header| !header.deep).flat_map(|header| &header.channels.list);
    let mut names: Vec<String> = all().take(LISTED).map(|channel| format!("`{}`", channel.name)).collect();
    if all().count() > LISTED {
        names.push("…".to_owned());
    }
    let is_chroma = |channel: &ChannelDescription| {
        let name = channel.name.to_string().to_ascii_uppercase();
        ["RY", "BY"].iter().any(|end| name == *end || name.ends_with(&format!(".{end}")))
    };
    let why = if all().any(is_chroma) {
        "luminance-chroma channels (`Y`, `RY`, `BY`) are not supported: save the image as `R`, `G` and `B`"
    } else if all().any(|channel| channel.sampling != Vec2(1, 1)) {
        "subsampled channels are not supported: save the image without subsampling"
    } else {
        "expected `R`, `G` and `B`, or `Y` alone, at the top level, in a single layer, or in a layer called `Combined`"
    };
    format!("the channels are {}; {why}", names.join(", "))
}

/// Returns the index in the display window of a pixel of the data window.
fn place(window: IntegerBounds, position: Vec2<i32>, at: Vec2<usize>) -> Option<usize> {
    let shifted = |at: usize, position: i32, corner: i32, size: usize| {
        let at = i64::try_from(at).ok()? + i64::from(position) - i64::from(corner);
        usize::try_from(at).ok().filter(|at| *at < size)
    };
    let x = shifted(at.x(), position.x(), window.position.x(), window.size.width())?;
    let y = shifted(at.y(), position.y(), window.position.y(), window.size.height())?;
    Some(y * window.size.width() + x)
}

/// Pixels, and the size of their data window.
struct Pixels(Vec<[f32; 3]>, Vec2<usize>);

fn rgb(
    path: &Path,
    [red, green, blue]: [Text; 3],
    window: IntegerBounds,
    progress: impl FnMut(f64),
) -> Result<Vec<[f32; 3]>, Error> {
    let channels = read().no_deep_data().largest_resolution_level().specific_channels();
    let channels = channels.required(red).required(green).required(blue).collect_pixels(
        |size, _| Pixels(vec![[0.0; 3]; size.area()], size),
        |Pixels(all, size), at, (r, g, b): (f32, f32, f32)| all[at.y() * size.width() + at.x()] = [r, g, b],
    );
    let image = channels.first_valid_layer().all_attributes().on_progress(progress).from_file(path)?;
    Ok(displayed(image.layer_data.channel_data.pixels, image.layer_data.attributes.layer_position, window))
}

fn gray(path: &Path, name: Text, window: IntegerBounds, progress: impl FnMut(f64)) -> Result<Vec<[f32; 3]>, Error> {
    let channels = read().no_deep_data().largest_resolution_level().specific_channels();
    let channels = channels.required(name).collect_pixels(
        |size, _| Pixels(vec![[0.0; 3]; size.area()], size),
        |Pixels(all, size), at, (y,): (f32,)| all[at.y() * size.width() + at.x()] = [y; 3],
    );
    let image = channels.first_valid_layer().all_attributes().on_progress(progress).from_file(path)?;
    Ok(displayed(image.layer_data.channel_data.pixels, image.layer_data.attributes.layer_position, window))
}

/// Returns the pixels of the display window, given the pixels of the data window.
fn displayed(Pixels(all, size): Pixels, position: Vec2<i32>, window: IntegerBounds) -> Vec<[f32; 3]> {
    if size == window.size && position == window.position {
        return all;
    }
    let mut displayed = vec![[0.0; 3]; window.size.area()];
    for (row, pixels) in all.chunks(size.width().max(1)).enumerate() {
        for (column, pixel) in pixels.iter().enumerate() {
            if let Some(at) = place(window, position, Vec2(column, row)) {
                displayed[at] = *pixel;
            }
        }
    }
    displayed
}

/// The largest ratio of the bytes of samples to the bytes of the file.
const DENSEST_EXR: u64 = 4 * DENSEST;

/// Returns the reason why a layer in a file of `bytes` bytes cannot have the size in its header, if any.
pub(crate) fn unlikely(header: &Header, bytes: u64) -> Option<String> {
    let (width, height) = (header.layer_size.0 as u64, header.layer_size.1 as u64);
    let each = header.channels.bytes_per_pixel as u64;
    let all = width.saturating_mul(height).saturating_mul(each);
    let problem = || {
        format!(
            "the header declares a layer of {width}×{height} pixels of {each} bytes, which do not fit into the \
             {bytes} bytes of the file"
        )
    };
    (all / DENSEST_EXR > bytes).then(problem)
}
