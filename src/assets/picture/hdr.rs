//! Radiance HDR: lines of text, then pixels of four bytes.
//!
//! *Theory.* `EXPOSURE` and `COLORCORR` are factors by which radiance was multiplied. All lines apply, because each
//! program that processed the image adds its own; a line that begins with a blank is history. `PRIMARIES` are chromaticities.
//!
//! *Practice.* The header is read here, and `image` decodes the pixels after it.

use std::fs::File;
use std::io::{BufRead, BufReader, Cursor, Read};
use std::path::Path;

use glam::{DMat3, DVec3};
use image::DynamicImage;
use image::codecs::hdr::HdrDecoder;

use super::Decoded;
use super::broken::broken;
use super::encoding::{convert, matrix_of};
use super::primaries::Primaries;
use crate::assets::format_error::are_padding;
use crate::progress::{Stage, Watched};

/// The first bytes of every file; the name of a program follows.
pub(super) const MAGIC: &[u8] = b"#?";
/// The largest length of a header in bytes.
const LONGEST: u64 = 1 << 20;

struct Header {
    size: [u32; 2],
    /// The divisor of the numbers.
    scale: DVec3,
    to_rec709: DMat3,
    notes: Vec<String>,
}

/// Reads the width and height from a file's header.
pub(super) fn size(path: &Path) -> Result<[u32; 2], String> {
    Ok(open(path, &Stage::unwatched())?.0.size)
}

/// Reads a file as radiance.
pub(super) fn read(path: &Path, stage: &Stage) -> Result<Decoded, String> {
    let (Header { size, scale, to_rec709, mut notes }, mut rest) = open(path, stage)?;
    // All files get the same header, in the form that `image` supports.
    let head = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", size[1], size[0]);
    let decoder = HdrDecoder::new(Cursor::new(head).chain(&mut rest)).map_err(|error| broken(&error))?;
    let image = DynamicImage::from_decoder(decoder).map_err(|error| broken(&error))?;
    let mut pixels: Vec<[f32; 3]> = image.into_rgb32f().pixels().map(|pixel| pixel.0).collect();
    notes.extend(convert(&mut pixels, to_rec709 * DMat3::from_diagonal(scale.recip())));
    let mut behind = Vec::new();
    rest.take(LONGEST).read_to_end(&mut behind).map_err(|error| broken(&error))?;
    if !are_padding(&behind) {
        notes.push(format!("the header declares {} rows, and the data after them is ignored", size[1]));
    }
    Ok(Decoded { pixels, notes })
}

fn open<'s>(path: &Path, stage: &'s Stage) -> Result<(Header, impl BufRead + use<'s>), String> {
    let file = File::open(path).map_err(|error| error.to_string())?;
    let mut reader = BufReader::new(Watched::new(file, stage));
    Ok((header(&mut reader)?, reader))
}

fn header(reader: &mut impl BufRead) -> Result<Header, String> {
    let mut lines = reader.take(LONGEST);
    let mut line = || -> Result<String, String> {
        let mut bytes = Vec::new();
        lines.read_until(b'\n', &mut bytes).map_err(|error| broken(&error))?;
        if bytes.pop() != Some(b'\n') {
            return Err("the header has no end".to_owned());
        }
        Ok(String::from_utf8_lossy(&bytes).trim_end().to_owned())
    };
    let (mut scale, mut primaries, mut notes) = (DVec3::ONE, None, Vec::new());
    line()?;
    loop {
        let line = line()?;
        if line.is_empty() {
            break;
        }
        let Some((key, value)) = line.split_once('=') else { continue };
        match key.trim_end() {
            "FORMAT" if value.trim() != "32-bit_rle_rgbe" => {
                let format = value.trim();
                return Err(format!(
                    "the FORMAT {format} is not supported; use 32-bit_rle_rgbe (`ra_xyze -r` converts XYZE)"
                ));
            }
            "EXPOSURE" => match numbers(value) {
                Some([exposure]) if is_factor(exposure) => scale *= exposure,
                _ => notes.push(unapplied(&line, "a number above 0")),
            },
            "COLORCORR" => match numbers::<3>(value) {
                Some(factors) if factors.into_iter().all(is_factor) => scale *= DVec3::from(factors),
                _ => notes.push(unapplied(&line, "three numbers above 0")),
            },
            "PRIMARIES" => match numbers(value) {
                Some(eight) => primaries = Some(Primaries::of(eight)),
                None => notes.push(unapplied(&line, "eight numbers: x and y of red, green, blue and white")),
            },
            _ => {}
        }
    }
    let size = resolution(&line()?)?;
    let to_rec709 = matrix_of(primaries.unwrap_or(Primaries::REC709), "PRIMARIES");
    notes.extend(to_rec709.as_ref().err().cloned());
    if !(scale.is_finite() && scale.recip().is_finite()) {
        return Err("the product of EXPOSURE and COLORCORR is out of range".to_owned());
    }
    Ok(Header { size, scale, to_rec709: to_rec709.unwrap_or_default(), notes })
}

fn is_factor(x: f64) -> bool {
    x.is_normal() && x > 0.0
}

fn unapplied(line: &str, expected: &str) -> String {
    format!("the header line `{line}` is ignored: expected {expected}")
}

/// Parses exactly `N` numbers.
fn numbers<const N: usize>(value: &str) -> Option<[f64; N]> {
    let all: Result<Vec<f64>, _> = value.split_whitespace().map(str::parse).collect();
    all.ok()?.try_into().ok()
}

/// Parses the line with width and height.
fn resolution(line: &str) -> Result<[u32; 2], String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let [y, height, x, width] = words[..] else {
        return Err(format!("expected `-Y HEIGHT +X WIDTH` after the header, found `{line}`"));
    };
    if [y, x] != ["-Y", "+X"] {
        return Err(format!("the orientation `{line}` is not supported: rotate the image to `-Y HEIGHT +X WIDTH`"));
    }
    let number = |word: &str| word.parse().map_err(|_| format!("`{word}` in `{line}` is not a valid number of pixels"));
    Ok([number(width)?, number(height)?])
}
