//! What made a picture: what its file says of that, and in what two of them differ.
//!
//! *Idea.* Pictures are put together, gone on with or taken for finished only if the same made them: the scene with its files, the method
//! with all of its numbers, the device and the version. The scene is in the file twice: as a hash of everything, and line by line, so that
//! what differs can be named by its key. Scenes of more lines than [`LISTED`] bytes have the hash alone.

use std::collections::BTreeMap;
use std::fmt;

use super::FileSettings;
use crate::render::Window;
use crate::scene::Tonemap;

/// How the rays were followed, as [`Rays::followed`](crate::scene::Rays::followed) has it.
pub const FOLLOWED: &str = "rays";
/// Whether its program kept all that a search for a method compares, `true` or `false`: on some devices another program rounds otherwise,
/// which makes no other picture of it.
pub const COMPARED: &str = "compared";
/// A hash of the scene and its files.
pub const SCENE: &str = "scene";
/// The scene's values, `key = value` a line.
pub const LINES: &str = "scene lines";
/// Samples of a pixel.
pub const SAMPLES: &str = "samples";
/// What rendered it.
pub const DEVICE: &str = "device";
/// How it is to be shown: exposure, tone map and bits.
pub(super) const SHOWN: &str = "shown";
/// The part of the picture, and the whole's size, for files that have no other place for it.
pub(super) const PART: &str = "part";

/// Bytes of a scene's lines, at most.
pub const LISTED: usize = 1 << 16;
/// Characters of a value that are shown.
const WIDTH: usize = 60;

/// The first thing that two pictures say differently.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// A key of the scene, or of what a picture says of itself.
    pub key: String,
    /// What each says; none where it says nothing.
    pub values: [Option<String>; 2],
}

impl Difference {
    /// What one of the two says.
    #[must_use]
    pub fn value(&self, which: usize) -> String {
        let Some(value) = &self.values[which] else { return "nothing".to_owned() };
        let cut: String = value.chars().take(WIDTH).collect();
        if cut.len() < value.len() { format!("`{cut}…`") } else { format!("`{cut}`") }
    }
}

impl fmt::Display for Difference {
    /// Of a picture and what is wanted.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "its `{}` is {}, not {}", self.key, self.value(0), self.value(1))
    }
}

/// What is in the file of the settings that a format has no place of its own for.
pub(super) fn shown_words(settings: &FileSettings) -> String {
    let name = Tonemap::NAMES.iter().find(|(_, tonemap)| *tonemap == settings.tonemap).map_or("", |(name, _)| name);
    format!("exposure {} tonemap {name} bits {}", settings.exposure, settings.bits)
}

/// The settings with what [`shown_words`] says.
pub(super) fn with_shown(settings: FileSettings, text: &str) -> Option<FileSettings> {
    let ["exposure", exposure, "tonemap", tonemap, "bits", bits] = text.split(' ').collect::<Vec<_>>()[..] else {
        return None;
    };
    let tonemap = Tonemap::NAMES.iter().find(|(name, _)| *name == tonemap)?.1;
    Some(FileSettings { exposure: exposure.parse().ok()?, tonemap, bits: bits.parse().ok()?, ..settings })
}

/// The part that a file holds, and the whole's size.
pub(super) fn part_words(settings: &FileSettings) -> String {
    let [width, height] = settings.size;
    format!("{} of {width}x{height}", settings.window)
}

/// The settings with what [`part_words`] says.
pub(super) fn with_part(settings: FileSettings, text: &str) -> Option<FileSettings> {
    let numbers: Vec<u32> = text.split([',', 'x', ' ']).filter_map(|word| word.parse().ok()).collect();
    let [x, y, w, h, width, height] = numbers[..] else { return None };
    Some(FileSettings { size: [width, height], window: Window { origin: [x, y], size: [w, h] }, ..settings })
}

/// In what two files differ, if they are not of one picture in the same part and form.
#[must_use]
pub fn file_difference(own: &FileSettings, wanted: &FileSettings) -> Option<String> {
    let words = |what: &str, of: fn(&FileSettings) -> String| {
        let [own, wanted] = [own, wanted].map(of);
        (own != wanted).then(|| format!("its `{what}` is `{own}`, not `{wanted}`"))
    };
    let layers = |settings: &FileSettings| {
        let names = settings.layers.iter().map(|layer| layer.name());
        names.chain(settings.alpha.then_some("alpha")).collect::<Vec<_>>().join(",")
    };
    words(PART, part_words)
        .or_else(|| words("layers", layers))
        .or_else(|| difference([&own.metadata, &wanted.metadata], &[]).map(|difference| difference.to_string()))
        .or_else(|| words(SHOWN, shown_words))
}

/// What two pictures say differently, but for these keys; none where they are alike.
#[must_use]
pub fn difference(pictures: [&[(String, String)]; 2], but: &[&str]) -> Option<Difference> {
    let said = pictures.map(|said| said.iter().map(|(key, text)| (key.as_str(), text.as_str())).collect());
    let counts = |key: &str| ![LINES, COMPARED].contains(&key) && !but.contains(&key);
    let found = first(&said, counts)?;
    if found.key != SCENE {
        return Some(found);
    }
    let lines = said.map(|said| said.get(LINES).copied().unwrap_or_default());
    let lines = lines.map(|text| text.lines().filter_map(|line| line.split_once(" = ")).collect());
    Some(first(&lines, |_| true).unwrap_or(found))
}

fn first(said: &[BTreeMap<&str, &str>; 2], counts: impl Fn(&str) -> bool) -> Option<Difference> {
    let [own, other] = said;
    let keys = own.keys().chain(other.keys()).filter(|key| counts(key) && own.get(*key) != other.get(*key));
    let key = *keys.min()?;
    Some(Difference { key: key.to_owned(), values: [own, other].map(|said| said.get(key).map(|s| (*s).to_owned())) })
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
