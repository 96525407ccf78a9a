//! The origin of an image, as stored in its file, and the comparison of two origins.
//!
//! *Idea.* Images are merged, resumed or accepted as finished only if their origins agree: the scene with its files, the method with all of
//! its numbers, the device and the version. The file contains the scene twice: as a hash of everything, and line by line, so that a message
//! can show the key that differs. If the lines exceed [`LISTED`] bytes, only the hash is stored.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::{self, Write};

use super::FileSettings;
use crate::program::Layer;
use crate::render::Window;
use crate::scene::{ARCSECOND, Scene, Tonemap};

/// The key of the ray settings, from [`Rays::followed`](crate::scene::Rays::followed).
pub const FOLLOWED: &str = "rays";
/// The key that is `true` if the program stored all data that a search for a method compares, and otherwise `false`: on some devices
/// rounding depends on the program, but the image counts as the same.
pub const COMPARED: &str = "compared";
/// The key of a hash of the scene and its files.
pub const SCENE: &str = "scene";
/// The key of the scene's values, one line `key = value` each.
pub const LINES: &str = "scene lines";
/// The key of the samples per pixel.
pub const SAMPLES: &str = "samples";
/// The key of the device.
pub const DEVICE: &str = "device";
/// The key of the scene's unit of length, in meters.
pub(super) const LENGTH: &str = "unit of length";
/// The key of the angle that a pixel at the center covers on the sky, in microarcseconds.
pub(super) const PIXEL: &str = "pixel on the sky";
/// The key of the display settings: exposure, tone map and bit depth.
pub(super) const SHOWN: &str = "shown";
/// The key of the part and the whole's size, for formats that do not store them otherwise.
pub(super) const PART: &str = "part";
/// The key of the names of the layers, for formats that do not store them otherwise.
const LAYERS: &str = "layers";
/// The name of alpha among the layers.
const ALPHA: &str = "alpha";

/// The largest size of a scene's lines, in bytes.
pub const LISTED: usize = 1 << 16;
/// The number of characters shown of a value.
const WIDTH: usize = 60;

/// The first difference of two origins.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// A key of the scene or of an image's metadata.
    pub key: String,
    /// The values of both; `None` for a missing value.
    pub values: [Option<String>; 2],
}

impl Difference {
    /// Returns one of the two values as text.
    #[must_use]
    pub fn value(&self, which: usize) -> String {
        let Some(value) = &self.values[which] else { return "nothing".to_owned() };
        let cut: String = value.chars().take(WIDTH).collect();
        if cut.len() < value.len() { format!("`{cut}…`") } else { format!("`{cut}`") }
    }
}

impl fmt::Display for Difference {
    /// Writes the difference between an image and the request.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "its `{}` is {}, not {}", self.key, self.value(0), self.value(1))
    }
}

/// Returns the metadata that the scene's `[units]` define.
#[must_use]
pub fn scale(scene: &Scene) -> Vec<(String, String)> {
    let length = scene.units.and_then(|units| units.length).map(|length| (LENGTH, format!("{length} m")));
    let pixel = scene.pixel_on_sky().map(|pixel| (PIXEL, format!("{} uas", pixel / ARCSECOND * 1e6)));
    length.into_iter().chain(pixel).map(|(key, text)| (key.to_owned(), text)).collect()
}

/// Returns the display settings for a format without separate fields for them.
pub(super) fn shown_words(settings: &FileSettings) -> String {
    let name = Tonemap::NAMES.iter().find(|(_, tonemap)| *tonemap == settings.tonemap).map_or("", |(name, _)| name);
    let glare = if settings.glare > 0.0 { format!(" glare {}", settings.glare) } else { String::new() };
    format!("exposure {} tonemap {name} bits {}{glare}", settings.exposure, settings.bits)
}

/// Returns the settings with the text of [`shown_words`].
pub(super) fn with_shown(settings: FileSettings, text: &str) -> Option<FileSettings> {
    let (exposure, tonemap, bits, glare) = match text.split(' ').collect::<Vec<_>>()[..] {
        ["exposure", exposure, "tonemap", tonemap, "bits", bits] => (exposure, tonemap, bits, "0"),
        ["exposure", exposure, "tonemap", tonemap, "bits", bits, "glare", glare] => (exposure, tonemap, bits, glare),
        _ => return None,
    };
    let tonemap = Tonemap::NAMES.iter().find(|(name, _)| *name == tonemap)?.1;
    Some(FileSettings {
        exposure: exposure.parse().ok()?,
        tonemap,
        bits: bits.parse().ok()?,
        glare: glare.parse().ok()?,
        ..settings
    })
}

/// Returns the part in a file, and the whole's size.
pub(super) fn part_words(settings: &FileSettings) -> String {
    let [width, height] = settings.size;
    format!("{} of {width}x{height}", settings.window)
}

/// Returns the settings with the text of [`part_words`].
pub(super) fn with_part(settings: FileSettings, text: &str) -> Option<FileSettings> {
    let numbers: Vec<u32> = text.split([',', 'x', ' ']).filter_map(|word| word.parse().ok()).collect();
    let [x, y, w, h, width, height] = numbers[..] else { return None };
    Some(FileSettings { size: [width, height], window: Window { origin: [x, y], size: [w, h] }, ..settings })
}

/// Returns the settings of a file as an object of JSON in ASCII.
pub(super) fn metadata_json(settings: &FileSettings) -> String {
    let own = [(PART, part_words(settings)), (SHOWN, shown_words(settings)), (LAYERS, layer_words(settings))];
    let said = settings.metadata.iter().map(|(key, text)| (key.as_str(), text.clone()));
    let all: BTreeMap<&str, String> = said.chain(own).collect();
    let mut ascii = String::new();
    for unit in serde_json::json!(all).to_string().encode_utf16() {
        match u8::try_from(unit) {
            Ok(byte @ b' '..=b'~') => ascii.push(byte.into()),
            _ => {
                let _ = write!(ascii, "\\u{unit:04x}");
            }
        }
    }
    ascii
}

/// Returns the settings of a text of [`metadata_json`].
pub(super) fn with_metadata_json(text: &str) -> Option<FileSettings> {
    let mut said: BTreeMap<String, String> = serde_json::from_str(text).ok()?;
    let [part, shown, layers] = [PART, SHOWN, LAYERS].map(|key| said.remove(key).unwrap_or_default());
    let names: Vec<&str> = layers.split(',').filter(|name| !name.is_empty()).collect();
    let settings = FileSettings {
        alpha: names.contains(&ALPHA),
        layers: Layer::ALL.into_iter().filter(|layer| names.contains(&layer.name())).collect(),
        metadata: said.into_iter().collect(),
        ..FileSettings::new([1, 1])
    };
    with_part(settings, &part).and_then(|settings| with_shown(settings, &shown))
}

/// Returns the names of the layers, and of alpha if the image has any.
fn layer_words(settings: &FileSettings) -> String {
    let names = settings.layers.iter().map(|layer| layer.name());
    names.chain(settings.alpha.then_some(ALPHA)).collect::<Vec<_>>().join(",")
}

/// Returns the difference of two files, if they do not store one part of one image in one format.
#[must_use]
pub fn file_difference(own: &FileSettings, wanted: &FileSettings) -> Option<String> {
    let words = |what: &str, of: fn(&FileSettings) -> String| {
        let [own, wanted] = [own, wanted].map(of);
        (own != wanted).then(|| format!("its `{what}` is `{own}`, not `{wanted}`"))
    };
    words(PART, part_words)
        .or_else(|| words(LAYERS, layer_words))
        .or_else(|| difference([&own.metadata, &wanted.metadata], &[]).map(|difference| difference.to_string()))
        .or_else(|| words(SHOWN, shown_words))
}

/// Returns the first difference of two origins except for these keys, or `None` if they agree.
#[must_use]
pub fn difference(pictures: [&[(String, String)]; 2], but: &[&str]) -> Option<Difference> {
    differences(pictures, but).into_iter().next()
}

/// Returns all differences of two origins except for these keys: of their metadata, and of the lines of their scenes.
#[must_use]
pub fn differences(pictures: [&[(String, String)]; 2], but: &[&str]) -> Vec<Difference> {
    let said = pictures.map(|said| said.iter().map(|(key, text)| (key.as_str(), text.as_str())).collect());
    let counts = |key: &str| ![LINES, COMPARED].contains(&key) && !but.contains(&key);
    let mut found = all(&said, counts);
    if let Some(at) = found.iter().position(|difference| difference.key == SCENE) {
        let lines = said.map(|said| said.get(LINES).copied().unwrap_or_default());
        let lines = lines.map(|text| text.lines().filter_map(|line| line.split_once(" = ")).collect());
        let of_lines = all(&lines, |_| true);
        if !of_lines.is_empty() {
            found.splice(at..=at, of_lines);
        }
    }
    found
}

fn all(said: &[BTreeMap<&str, &str>; 2], counts: impl Fn(&str) -> bool) -> Vec<Difference> {
    let [own, other] = said;
    let keys: BTreeSet<&str> = own.keys().chain(other.keys()).copied().collect();
    let differ = keys.into_iter().filter(|key| counts(key) && own.get(key) != other.get(key));
    let value = |key: &str| [own, other].map(|said| said.get(key).map(|text| (*text).to_owned()));
    differ.map(|key| Difference { key: key.to_owned(), values: value(key) }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(pairs: &[(&str, &str)]) -> Vec<(String, String)> {
        pairs.iter().map(|(key, text)| ((*key).to_owned(), (*text).to_owned())).collect()
    }

    #[test]
    fn what_differs_is_named_by_its_key() {
        let one = said(&[(SCENE, "1"), (LINES, "a = 1\nb = 2\n"), (DEVICE, "d")]);
        let words = |other: &[(&str, &str)], but: &[&str]| {
            difference([&one, &said(other)], but).map(|difference| difference.to_string())
        };
        assert_eq!(words(&[(DEVICE, "d"), (SCENE, "1"), (LINES, "a = 1\nb = 2\n")], &[]), None);
        assert_eq!(words(&[(DEVICE, "d"), (SCENE, "1"), (COMPARED, "true")], &[]), None);
        let scene = [(SCENE, "2"), (LINES, "a = 1\nc = 2\n"), (DEVICE, "d")];
        assert_eq!(words(&scene, &[]).unwrap(), "its `b` is `2`, not nothing");
        assert_eq!(words(&scene, &[SCENE]), None);
        assert_eq!(words(&[(SCENE, "2"), (DEVICE, "d")], &[]).unwrap(), "its `a` is `1`, not nothing");
        assert_eq!(words(&[(SCENE, "1"), (DEVICE, "e")], &[]).unwrap(), "its `device` is `d`, not `e`");
        let long = "é".repeat(70);
        let difference = difference([&said(&[("k", &long)]), &said(&[])], &[]).unwrap();
        assert_eq!(difference.value(0), format!("`{}…`", "é".repeat(60)));
    }
}
