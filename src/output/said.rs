//! The metadata of images, read from their files.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use super::fits::settings_of_fits;
use super::hdf5::settings_of_hdf5;
use super::npy::settings_of_npz;
use super::origin::{PART, SHOWN, with_part, with_shown};
use super::part::{ImagePart, said_by_exr};
use super::{FileSettings, OutputError, has_extension, stores_layers};

/// Returns the metadata under `key` of the image at `path`.
///
/// # Errors
///
/// Returns an error if the file cannot be read, has another format, or lacks the key.
pub fn said(path: &Path, key: &str) -> Result<String, OutputError> {
    let text = match () {
        () if has_extension(path, "exr") => said_by_exr(path, key)?,
        () if has_extension(path, "png") => said_by_png(path, key)?,
        () if stores_layers(path) => settings_of(path)?.said(key).map(str::to_owned),
        () => return Err(OutputError::Format { path: path.to_owned() }),
    };
    text.ok_or_else(|| {
        unsaid(path, format!("it has no metadata `{key}`, which images from this version of `render` contain"))
    })
}

/// Returns the settings with which the image at `path` was written: all of [`FileSettings`], with texts sorted by key.
///
/// # Errors
///
/// Returns an error if the file cannot be read, or is not an image that `render` writes.
pub fn settings_of(path: &Path) -> Result<FileSettings, OutputError> {
    if has_extension(path, "exr") {
        return Ok(ImagePart::open(path)?.settings);
    }
    if stores_layers(path) {
        let found = match () {
            () if has_extension(path, "npz") => settings_of_npz(path)?,
            () if has_extension(path, "fits") => settings_of_fits(path)?,
            () => settings_of_hdf5(path)?,
        };
        return found.ok_or_else(|| unsaid(path, "this image was not written by `render`".to_owned()));
    }
    let reader = png_reader(path)?;
    let info = reader.info();
    let latin = info.uncompressed_latin1_text.iter().map(|chunk| (chunk.keyword.clone(), chunk.text.clone()));
    let utf8 = info.utf8_text.iter().filter_map(|chunk| Some((chunk.keyword.clone(), chunk.get_text().ok()?)));
    let mut said: BTreeMap<String, String> = latin.chain(utf8).collect();
    let own = [PART, SHOWN].map(|key| said.remove(key).unwrap_or_default());
    let settings = FileSettings {
        alpha: info.color_type == png::ColorType::Rgba,
        metadata: said.into_iter().collect(),
        ..FileSettings::new([info.width, info.height])
    };
    let settings = with_part(settings, &own[0]).and_then(|settings| with_shown(settings, &own[1]));
    settings.ok_or_else(|| unsaid(path, "this image was not written by `render`".to_owned()))
}

fn said_by_png(path: &Path, key: &str) -> Result<Option<String>, OutputError> {
    let reader = png_reader(path)?;
    let texts = &reader.info().uncompressed_latin1_text;
    Ok(texts.iter().find(|chunk| chunk.keyword == key).map(|chunk| chunk.text.clone()))
}

/// Returns a reader that has read everything before the pixels.
fn png_reader(path: &Path) -> Result<png::Reader<BufReader<File>>, OutputError> {
    let file = File::open(path).map_err(|cause| OutputError::Read { path: path.to_owned(), cause })?;
    let broken = |error: png::DecodingError| unsaid(path, format!("this is not a complete PNG: {error}"));
    png::Decoder::new(BufReader::new(file)).read_info().map_err(broken)
}

fn unsaid(path: &Path, problem: String) -> OutputError {
    OutputError::Part { path: path.to_owned(), problem }
}
