//! NRRD ("nearly raw raster data", <https://teem.sourceforge.net/nrrd/format.html>):
//! a header of text lines, an empty line, and the samples.
//!
//! *Practice.* The reader supports volumes with three axes along x, y and z. The samples, raw or gzipped, follow the header or are in
//! one separate file, after the lines and bytes that `line skip` and `byte skip` specify. Anything else is an error with its line.
//! Fields that do not concern the positions and the meaning of samples (content, units, kinds, …) are ignored.
//!
//! *Length.* Over 300 lines, because it reads one format, from header to samples, with a message for every field.

use super::{RawGridLayout, Stored, Volume, count};
use crate::document::{Diagnostic, SceneError, lenient_text, read_bytes, unmarked};
use glam::DVec3;
use std::borrow::Cow;
use std::io::Read as _;
use std::path::{Path, PathBuf};

/// A field of the header, and its value as a part of the file.
type Field<'a> = (String, &'a str);

/// An error in a piece of the header: the piece, the problem and the remedy.
type Wrong<'a> = (&'a str, String, String);

pub(super) fn read(bytes: &[u8], path: &Path) -> Result<Volume, SceneError> {
    let bytes = unmarked(bytes, path)?;
    let (header, behind) = split(bytes);
    // Comments may be in any encoding; byte positions are only used for the words found here.
    let header = lenient_text(header, path)?;
    let wrong = |(word, problem, help): Wrong| {
        // A word is a slice of the text, so the difference of the addresses is its offset.
        SceneError::Diagnostics(vec![Diagnostic::of(path, &header, word, problem, help)])
    };
    let volume = Header::read(&header).map_err(wrong)?;
    // If there are too many samples, none are read; the caller rejects their number.
    let samples = count(volume.bare.size).unwrap_or(0);
    let wanted = samples * volume.bare.stored.bytes();
    let data = volume.data.map(|name| Ok((data_file(name, path)?, name))).transpose().map_err(wrong)?;
    let skip = volume.skip;
    let stored = match &data {
        None => Cow::Borrowed(behind),
        Some((file, name)) => {
            // If the file has a different length, none of it is read.
            let length = std::fs::metadata(file).map_or(wanted as u64, |file| file.len());
            if samples > 0 && !volume.zipped && !skip.leaves(wanted as u64, length) {
                let problem = format!("the file has {length} bytes, and the samples require {wanted}");
                let help = "check `sizes`, `type`, `encoding`, `line skip` and `byte skip`".to_owned();
                return Err(wrong((name, problem, help)));
            }
            Cow::Owned(if samples > 0 { read_bytes(file)? } else { Vec::new() })
        }
    };
    let begin = if samples > 0 { skip.lines_end(&stored).map_err(wrong)? } else { 0 };
    let bytes = if volume.zipped {
        unzipped(&stored[begin..], skip, wanted).map_err(|error| SceneError::Grid {
            path: path.to_owned(),
            problem: format!("the samples cannot be decompressed: {error}"),
        })?
    } else {
        let mut bytes = stored.into_owned();
        bytes.drain(..skip.begin(begin, wanted, bytes.len()));
        bytes
    };
    Ok(Volume { bare: volume.bare, place: volume.place, bytes, data: data.map(|(file, _)| file) })
}

/// Unpacks the samples, and at most one byte more than `wanted`, to detect surplus data without unpacking all of it.
fn unzipped(stored: &[u8], skip: Skip, wanted: usize) -> std::io::Result<Vec<u8>> {
    let mut unpacked = flate2::read::MultiGzDecoder::new(stored);
    std::io::copy(&mut unpacked.by_ref().take(skip.bytes.unwrap_or(0)), &mut std::io::sink())?;
    let mut bytes = Vec::new();
    unpacked.take(wanted as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The part of the data before the samples: lines first, then bytes, which are counted after unpacking.
#[derive(Clone, Copy)]
struct Skip<'a> {
    lines: u64,
    /// The value of `line skip` as written, for error messages.
    lines_text: &'a str,
    /// `None` if the samples are at the end of the file.
    bytes: Option<u64>,
}

impl<'a> Skip<'a> {
    fn read(fields: &[Field<'a>], zipped: bool) -> Result<Self, Wrong<'a>> {
        let given = |names: &[&str]| find(fields, names).map_or("0", |(_, value)| *value);
        let (lines_text, bytes_text) = (given(&["line skip", "lineskip"]), given(&["byte skip", "byteskip"]));
        let lines = lines_text.parse().map_err(|_| {
            let problem = format!("expected a number of lines, found `{lines_text}`");
            (lines_text, problem, "give the number of lines before the samples, 0 or more".to_owned())
        })?;
        let bytes = match bytes_text {
            "-1" if zipped => {
                let problem = "`byte skip: -1` is valid only for uncompressed samples".to_owned();
                return Err((bytes_text, problem, "give the number of bytes before the samples".to_owned()));
            }
            "-1" => None,
            _ => Some(bytes_text.parse().map_err(|_| {
                let problem = format!("expected a number of bytes, found `{bytes_text}`");
                (bytes_text, problem, "use 0 or more, or -1 if the samples are at the end of the file".to_owned())
            })?),
        };
        Ok(Self { lines, lines_text, bytes })
    }

    /// Returns `true` if an unpacked file of `length` bytes can hold `wanted` bytes of samples after the skipped part.
    fn leaves(&self, wanted: u64, length: u64) -> bool {
        match (self.lines, self.bytes) {
            (0, Some(bytes)) => length == wanted.saturating_add(bytes),
            _ => length >= wanted,
        }
    }

    /// Returns the offset after the skipped lines, which may have any line ending.
    fn lines_end(&self, data: &[u8]) -> Result<usize, Wrong<'a>> {
        let mut at = 0;
        for line in 0..self.lines {
            let Some(length) = data[at..].iter().position(|byte| matches!(byte, b'\n' | b'\r')) else {
                let problem = format!("the data has only {line} lines");
                return Err((self.lines_text, problem, String::new()));
            };
            at += length + if data[at + length..].starts_with(b"\r\n") { 2 } else { 1 };
        }
        Ok(at)
    }

    /// Returns the offset of the samples in `length` bytes of unpacked data whose skipped lines end at `lines_end`.
    fn begin(&self, lines_end: usize, wanted: usize, length: usize) -> usize {
        let begin = match self.bytes {
            Some(bytes) => usize::try_from(bytes).unwrap_or(length).saturating_add(lines_end),
            None => length.saturating_sub(wanted).max(lines_end),
        };
        begin.min(length)
    }
}

/// Returns the one file of samples that a header names, relative to the header's folder.
fn data_file<'a>(name: &'a str, header: &Path) -> Result<PathBuf, Wrong<'a>> {
    let is_list = name == "LIST" || name.starts_with("LIST ");
    let is_pattern = name.contains('%') && name.contains(' ');
    if is_list || is_pattern {
        let problem = "samples in several files are not supported".to_owned();
        return Err((name, problem, "join the files, and give the name of the result".to_owned()));
    }
    let file = header.parent().unwrap_or(Path::new("")).join(name);
    if file.is_file() {
        return Ok(file);
    }
    let help = "the name of a data file is relative to the folder of its header".to_owned();
    Err((name, format!("the file `{}` does not exist", file.display()), help))
}

/// Splits a file at the first empty line. All lines of the header end like the first, because any byte may follow the header.
fn split(bytes: &[u8]) -> (&[u8], &[u8]) {
    let first = bytes.iter().position(|byte| matches!(byte, b'\r' | b'\n'));
    let is_old_mac = first.is_some_and(|at| bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n'));
    let line_end = if is_old_mac { b'\r' } else { b'\n' };
    let mut start = 0;
    while let Some(length) = bytes[start..].iter().position(|byte| *byte == line_end) {
        let line = &bytes[start..start + length];
        if line.is_empty() || line == b"\r" {
            return (&bytes[..start], &bytes[start + length + 1..]);
        }
        start += length + 1;
    }
    (bytes, &[])
}

struct Header<'a> {
    bare: RawGridLayout,
    place: Option<(DVec3, DVec3)>,
    zipped: bool,
    skip: Skip<'a>,
    /// The name in the header of a separate file with the samples.
    data: Option<&'a str>,
}

impl<'a> Header<'a> {
    fn read(text: &'a str) -> Result<Self, Wrong<'a>> {
        let mut lines = text.lines();
        let magic = lines.next().unwrap_or("");
        if !magic.starts_with("NRRD000") {
            let help =
                "a NRRD file begins with a line such as NRRD0004; for raw numbers, set the size and type in the scene"
                    .to_owned();
            return Err((&text[..magic.len()], "not a NRRD file".to_owned(), help));
        }
        let mut fields = Vec::new();
        for line in lines.filter(|line| !line.starts_with('#') && !line.contains(":=")) {
            let Some((name, value)) = line.split_once(':') else {
                return Err((
                    line,
                    "expected `field: value`".to_owned(),
                    "end the header with an empty line".to_owned(),
                ));
            };
            let name = name.trim().to_lowercase();
            if let Some((_, first)) = fields.iter().find(|(known, _): &&Field| *known == name) {
                let help = format!("the first value is `{first}`");
                return Err((line, format!("`{name}` is defined twice"), help));
            }
            fields.push((name, value.trim()));
        }
        let data = find(&fields, &["data file", "datafile"]).map(|(_, name)| *name);
        let required = |names: &[&str], example: &str| {
            let missing = || {
                (
                    &text[..magic.len()],
                    format!("the header has no `{}`", names[0]),
                    format!("for example {}: {example}", names[0]),
                )
            };
            find(&fields, names).map(|(_, value)| *value).ok_or_else(missing)
        };
        if let Some((_, dimension)) = find(&fields, &["dimension"]).filter(|(_, value)| *value != "3") {
            return Err((dimension, "only three-dimensional volumes are supported".to_owned(), String::new()));
        }
        let size = size(required(&["sizes"], "64 64 64")?)?;
        let stored = stored(required(&["type"], "float")?)?;
        let zipped = is_zipped(required(&["encoding"], "raw")?)?;
        let skip = Skip::read(&fields, zipped)?;
        let little = match find(&fields, &["endian"]) {
            Some((_, "little")) => true,
            Some((_, "big")) => false,
            Some((_, other)) => {
                return Err((other, format!("unknown endianness `{other}`"), "use little or big".to_owned()));
            }
            None if stored.bytes() == 1 => true,
            None => required(&["endian"], "little").map(|_| true)?,
        };
        Ok(Self { bare: RawGridLayout { size, stored, little }, place: place(&fields)?, zipped, skip, data })
    }
}

fn is_zipped(encoding: &str) -> Result<bool, Wrong<'_>> {
    match encoding {
        "raw" => Ok(false),
        "gzip" | "gz" => Ok(true),
        _ => {
            let problem = format!("the encoding `{encoding}` is not supported");
            Err((encoding, problem, "supported: raw, gzip".to_owned()))
        }
    }
}

fn find<'f, 'a>(fields: &'f [Field<'a>], names: &[&str]) -> Option<&'f Field<'a>> {
    fields.iter().find(|(name, _)| names.contains(&name.as_str()))
}

fn size(value: &str) -> Result<[u32; 3], Wrong<'_>> {
    let sizes: Option<Vec<u32>> = value.split_whitespace().map(|word| word.parse().ok()).collect();
    let wrong = || {
        (
            value,
            "expected three sizes".to_owned(),
            "give the number of samples along x, y and z, such as 64 64 64".to_owned(),
        )
    };
    sizes.and_then(|sizes| sizes.try_into().ok()).ok_or_else(wrong)
}

/// Parses the name of a number type; the format has several names for each type.
fn stored(value: &str) -> Result<Stored, Wrong<'_>> {
    match value {
        "signed char" | "int8" | "int8_t" => Ok(Stored::I8),
        "uchar" | "unsigned char" | "uint8" | "uint8_t" => Ok(Stored::U8),
        "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => Ok(Stored::I16),
        "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => Ok(Stored::U16),
        "int" | "signed int" | "int32" | "int32_t" => Ok(Stored::I32),
        "uint" | "unsigned int" | "uint32" | "uint32_t" => Ok(Stored::U32),
        "longlong"
        | "long long"
        | "long long int"
        | "signed long long"
        | "signed long long int"
        | "int64"
        | "int64_t" => Ok(Stored::I64),
        "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => Ok(Stored::U64),
        "float" => Ok(Stored::F32),
        "double" => Ok(Stored::F64),
        _ => {
            let help = "supported: int8 to int64, uint8 to uint64, float, double".to_owned();
            Err((value, format!("samples of type `{value}` are not supported"), help))
        }
    }
}

/// Returns the position of the first sample and the distance to the next along each axis, if the header contains the distances.
fn place<'a>(fields: &[Field<'a>]) -> Result<Option<(DVec3, DVec3)>, Wrong<'a>> {
    let cell = match (find(fields, &["space directions"]), find(fields, &["spacings"])) {
        (Some((_, value)), _) => diagonal(value)?,
        (None, Some((_, value))) => {
            let help = "use numbers above 0 along x, y and z, such as 0.1 0.1 0.1";
            let spacings = value.split_whitespace().map(|word| word.parse().ok()).collect::<Option<Vec<f64>>>();
            spacings
                .and_then(three)
                .filter(|cell| cell.min_element() > 0.0)
                .ok_or_else(|| (*value, "expected three spacings".to_owned(), help.to_owned()))?
        }
        (None, None) => return Ok(None),
    };
    let origin = match find(fields, &["space origin"]) {
        Some((_, value)) => vector(value)
            .ok_or_else(|| (*value, "expected a position".to_owned(), "for example (0, 0, 0)".to_owned()))?,
        None => DVec3::ZERO,
    };
    Ok(Some((origin, cell)))
}

/// Parses `(a, 0, 0) (0, b, 0) (0, 0, c)` as (a, b, c).
fn diagonal(value: &str) -> Result<DVec3, Wrong<'_>> {
    let wrong = |problem: &str| (value, problem.to_owned(), "for example (0.1,0,0) (0,0.1,0) (0,0,0.1)".to_owned());
    let vectors: Option<Vec<DVec3>> = value.split_inclusive(')').map(vector).collect();
    let Some(Ok([x, y, z])) = vectors.map(<[DVec3; 3]>::try_from) else {
        return Err(wrong("expected three directions"));
    };
    let cell = DVec3::new(x.x, y.y, z.z);
    if [x, y, z] != [cell * DVec3::X, cell * DVec3::Y, cell * DVec3::Z] || cell.min_element() <= 0.0 {
        return Err(wrong("the directions must be along x, y and z, in this order"));
    }
    Ok(cell)
}

/// Parses `(x, y, z)`.
fn vector(text: &str) -> Option<DVec3> {
    let inside = text.trim().strip_prefix('(')?.strip_suffix(')')?;
    three(inside.split(',').map(|word| word.trim().parse().ok()).collect::<Option<_>>()?)
}

fn three(numbers: Vec<f64>) -> Option<DVec3> {
    let numbers = <[f64; 3]>::try_from(numbers).ok()?;
    numbers.iter().all(|x| x.is_finite() && x.abs() <= 1e30).then(|| DVec3::from_array(numbers))
}
