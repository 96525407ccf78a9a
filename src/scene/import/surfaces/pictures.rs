//! The import of images: external ones are referenced, and embedded ones are written to files.

use std::collections::HashMap;
use std::io::Cursor;
use std::path::Path;

use image::ImageReader;

use super::super::text::{Left, relative};
use crate::assets::{Gltf, Picture, StoredPicture};

/// The images in use.
pub(super) struct Pictures<'a> {
    file: &'a Gltf,
    folder: &'a Path,
    stem: String,
    /// The names in the scene by index in the file; `None` for an unusable image.
    names: HashMap<usize, Option<String>>,
    /// The names and contents of embedded images to write.
    pub within: Vec<(String, Vec<u8>)>,
}

impl<'a> Pictures<'a> {
    pub fn new(file: &'a Gltf, folder: &'a Path, stem: &str) -> Self {
        Self { file, folder, stem: stem.to_owned(), names: HashMap::new(), within: Vec::new() }
    }

    /// Returns the path of an image in the scene, or `None` if it is unusable.
    pub fn path(&mut self, number: usize, left: &mut Left) -> Option<String> {
        if let Some(known) = self.names.get(&number) {
            return known.clone();
        }
        let name = self.found(number, left);
        self.names.insert(number, name.clone());
        name
    }

    fn found(&mut self, number: usize, left: &mut Left) -> Option<String> {
        let called = self.called(number);
        let stored = self.readable(number).map_err(|what| left.out(&what, &called)).ok()?;
        match stored {
            (StoredPicture::Beside(path), _) => Some(relative(&path, self.folder)),
            (StoredPicture::Within(bytes), end) => {
                let plain = |c: char| if c.is_alphanumeric() || "-_".contains(c) { c } else { '_' };
                let front = format!("{}-{}", self.stem, called.chars().take(60).map(plain).collect::<String>());
                let mut name = format!("{front}.{end}");
                if self.within.iter().any(|(known, _)| known.eq_ignore_ascii_case(&name)) {
                    name = format!("{front}-{number}.{end}");
                }
                self.within.push((name.clone(), bytes));
                Some(name)
            }
        }
    }

    /// Returns the name of an image in messages.
    fn called(&self, number: usize) -> String {
        let own = self.file.root.images.get(number).and_then(|image| image.name.clone());
        own.filter(|name| !name.is_empty()).unwrap_or_else(|| format!("image {number}"))
    }

    /// Returns an image that bentray can read, with its file extension, or the kind of an unsupported image.
    fn readable(&self, number: usize) -> Result<(StoredPicture, &'static str), String> {
        let stored = self.file.image(number).map_err(|error| format!("unreadable images ({error})"))?;
        let start = match &stored {
            StoredPicture::Beside(path) if !path.exists() => return Err("missing image files".to_owned()),
            StoredPicture::Beside(path) => {
                Picture::start(path).map_err(|error| format!("unreadable images ({error})"))?
            }
            StoredPicture::Within(bytes) => bytes.clone(),
        };
        let ending = Picture::ending(&start).map_err(|kind| {
            format!("images {kind}, which bentray does not support; convert them to PNG or JPEG and export again")
        })?;
        Ok((stored, ending))
    }

    /// Returns the means of its channels, from 0 to 1, or `None` if it cannot be read.
    pub fn mean(&self, number: usize, left: &mut Left) -> Option<[f64; 3]> {
        let mut refuse = |what: String| left.out(&what, &self.called(number));
        let bytes = match self.readable(number).map_err(&mut refuse).ok()?.0 {
            StoredPicture::Beside(path) => {
                std::fs::read(path).map_err(|error| refuse(format!("unreadable images ({error})"))).ok()?
            }
            StoredPicture::Within(bytes) => bytes,
        };
        let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format().ok()?;
        let decoded = reader.decode().map_err(|error| refuse(format!("unreadable images ({error})")));
        let pixels = decoded.ok()?.into_rgb8();
        let count = pixels.pixels().len().max(1) as f64;
        let mut sums = [0.0; 3];
        for pixel in pixels.pixels() {
            sums.iter_mut().zip(pixel.0).for_each(|(sum, value)| *sum += f64::from(value));
        }
        Some(sums.map(|sum| sum / (255.0 * count)))
    }
}
