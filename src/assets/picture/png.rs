//! Color information of a PNG: code points, an ICC profile, sRGB, or a gamma
//! and chromaticities, in this order of precedence (PNG, third edition, 4.3).

use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::path::Path;

use ::png::{CodingIndependentCodePoints, Decoder, Info, ScaledFloat};

use super::broken::broken;
use super::encoding::{Curve, Encoding, decode_srgb, matrix_of};
use super::primaries::Primaries;

/// Reads the color information before the pixels.
pub(super) fn encoding(path: &Path) -> Result<Encoding, String> {
    let file = File::open(path).map_err(|error| error.to_string())?;
    let reader = Decoder::new(BufReader::new(file)).read_info().map_err(|error| broken(&error))?;
    let info = reader.info();
    let mut encoding = of(info);
    let there = chunks(path).map_err(|error| broken(&error))?;
    // `png` ignores invalid chunks.
    for (name, is_read) in [
        (b"cICP", info.coding_independent_code_points.is_some()),
        (b"iCCP", info.icc_profile.is_some()),
        (b"sRGB", info.srgb.is_some()),
        (b"gAMA", info.gama_chunk.is_some()),
        (b"cHRM", info.chrm_chunk.is_some()),
    ] {
        if !is_read && there.contains(name) {
            encoding.notes.push(format!("the {} chunk is malformed and ignored", String::from_utf8_lossy(name)));
        }
    }
    Ok(encoding)
}

/// Reads the names of the chunks before the pixels.
fn chunks(path: &Path) -> io::Result<Vec<[u8; 4]>> {
    let mut file = BufReader::new(File::open(path)?);
    file.seek(SeekFrom::Start(8))?;
    let mut names = Vec::new();
    loop {
        let mut head = [0; 8];
        file.read_exact(&mut head)?;
        let [a, b, c, d, name @ ..] = head;
        if &name == b"IDAT" {
            return Ok(names);
        }
        names.push(name);
        // A checksum follows.
        file.seek_relative(i64::from(u32::from_be_bytes([a, b, c, d])) + 4)?;
    }
}

fn of(info: &Info) -> Encoding {
    if let Some(points) = &info.coding_independent_code_points {
        return of_points(*points);
    }
    if let Some(profile) = &info.icc_profile {
        return Encoding::of_profile(profile);
    }
    if info.srgb.is_some() {
        return Encoding::default();
    }
    let number = |x: ScaledFloat| f64::from(x.into_scaled()) / 100_000.0;
    let power = info.gama_chunk.map(|gamma| 1.0 / number(gamma));
    let curve = || match power {
        Some(power) => Box::new(move |x: f64| x.powf(power)) as Curve,
        None => Box::new(decode_srgb),
    };
    let primaries = info.chrm_chunk.map_or(Primaries::REC709, |c| {
        let [red, green, blue, white] = [c.red, c.green, c.blue, c.white].map(|(x, y)| [number(x), number(y)]);
        Primaries::of([red[0], red[1], green[0], green[1], blue[0], blue[1], white[0], white[1]])
    });
    let to_rec709 = matrix_of(primaries, "chromaticities (cHRM)");
    let notes = to_rec709.as_ref().err().cloned().into_iter().collect();
    Encoding { notes, ..Encoding::new(curve, to_rec709.unwrap_or_default()) }
}

/// Converts the code points of ITU-T H.273, if they allow conversion to linear light.
fn of_points(points: CodingIndependentCodePoints) -> Encoding {
    let primaries = match points.color_primaries {
        1 => Some(Primaries::REC709),
        9 => Some(Primaries::REC2020),
        12 => Some(Primaries::DISPLAY_P3),
        _ => None,
    };
    let curve: Option<fn() -> Curve> = match points.transfer_function {
        4 => Some(|| Box::new(|x: f64| x.powf(2.2))),
        5 => Some(|| Box::new(|x: f64| x.powf(2.8))),
        8 => Some(|| Box::new(|x: f64| x)),
        13 => Some(|| Box::new(decode_srgb)),
        _ => None,
    };
    let is_full = points.is_video_full_range_image && points.matrix_coefficients == 0;
    match (primaries.and_then(Primaries::to_rec709), curve) {
        (Some(to_rec709), Some(curve)) if is_full => Encoding::new(curve, to_rec709),
        _ => Encoding::unapplied(format!(
            "the code points (cICP {}, {}, {}, {}) are ignored: convert the image to sRGB",
            points.color_primaries,
            points.transfer_function,
            points.matrix_coefficients,
            u8::from(points.is_video_full_range_image)
        )),
    }
}
