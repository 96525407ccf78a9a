//! The pictures of a file: those beside it are named, those within it get files of their own.

use std::collections::HashMap;
use std::io::Cursor;
use std::path::Path;

use image::{ImageFormat, ImageReader};

use super::super::text::{Left, relative};
use crate::assets::{Gltf, StoredPicture};

/// The pictures that are used.
pub(super) struct Pictures<'a> {
    file: &'a Gltf,
    folder: &'a Path,
    stem: String,
    /// Their names in the scene, by their numbers in the file; none of one that cannot be used.
    names: HashMap<usize, Option<String>>,
    /// Those to write, and what is in them.
    pub within: Vec<(String, Vec<u8>)>,
}

impl<'a> Pictures<'a> {
    pub fn new(file: &'a Gltf, folder: &'a Path, stem: &str) -> Self {
        Self { file, folder, stem: stem.to_owned(), names: HashMap::new(), within: Vec::new() }
    }

    /// What a scene calls the picture of this number; none if it cannot be used.
    pub fn path(&mut self, number: usize, left: &mut Left) -> Option<String> {
        if let Some(known) = self.names.get(&number) {
            return known.clone();
        }
        let name = self.found(number, left);
        self.names.insert(number, name.clone());
        name
    }

    fn found(&mut self, number: usize, left: &mut Left) -> Option<String> {
        let own = self.file.root.images.get(number).and_then(|image| image.name.clone());
        let called = own.clone().filter(|name| !name.is_empty()).unwrap_or_else(|| format!("picture {number}"));
        let mut refuse = |what: &str| {
            left.out(what, &called);
            None
        };
        match self.file.image(number) {
            Err(error) => refuse(&format!("pictures that cannot be read: {error}")),
            Ok(StoredPicture::Beside(path)) if !path.exists() => refuse("pictures that are not there"),
            Ok(StoredPicture::Beside(path)) => Some(relative(&path, self.folder)),
            Ok(StoredPicture::Within(bytes)) => {
                let end = match image::guess_format(&bytes) {
                    Ok(ImageFormat::Png) => "png",
                    Ok(ImageFormat::Jpeg) => "jpg",
                    _ => return refuse("pictures that are neither PNG nor JPEG"),
                };
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

    /// The means of its numbers, each from 0 to 1; none if it cannot be read.
    pub fn mean(&self, number: usize) -> Option<[f64; 3]> {
        let bytes = match self.file.image(number).ok()? {
            StoredPicture::Beside(path) => std::fs::read(path).ok()?,
            StoredPicture::Within(bytes) => bytes,
        };
        let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format().ok()?;
        let pixels = reader.decode().ok()?.into_rgb8();
        let count = pixels.pixels().len().max(1) as f64;
        let mut sums = [0.0; 3];
        for pixel in pixels.pixels() {
            sums.iter_mut().zip(pixel.0).for_each(|(sum, value)| *sum += f64::from(value));
        }
        Some(sums.map(|sum| sum / (255.0 * count)))
    }
}
