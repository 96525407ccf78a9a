//! STL: separate triangles.
//!
//! *Theory.* A binary file has 80 arbitrary bytes, the number of triangles in four bytes, and 50 bytes for each triangle: its normal, its
//! three corners and two more bytes. A text file has loops of `vertex` lines. The normals in the file are ignored, because the
//! order of the corners defines them exactly.
//!
//! *Practice.* Many binary files also begin with the word `solid`. A file
//! with exactly the size that its number of triangles needs is binary.

use std::path::Path;

use glam::{DVec3, Vec3};

use super::bytes::{Bytes, usable};
use super::raw::{Corner, MOST_CORNERS, Raw, too_many};
use super::text::{Diagnostics, Wrong, numbers, words};
use super::{Format, Read, Reading};
use crate::assets::format_error::FormatError;
use crate::document::{SceneError, lenient_text, unmarked};

pub(super) const FORMAT: Format = Format { extensions: &["stl"], read: Read::Whole(read) };

/// The number of bytes before the triangles of a binary file.
const HEADER: usize = 84;
/// The size in bytes of a triangle in a binary file.
const TRIANGLE: usize = 50;

fn read(bytes: &[u8], path: &Path, reading: Reading) -> Result<Raw, SceneError> {
    let stated = bytes.get(HEADER - 4..).and_then(|rest| rest.first_chunk()).map(|bytes| u32::from_le_bytes(*bytes));
    let is_whole = |count: u32| HEADER + count as usize * TRIANGLE == bytes.len();
    if let Some(count) = stated.filter(|count| is_whole(*count)) {
        return binary(bytes, count, reading).map_err(|flaw| flaw.of(path));
    }
    let text = unmarked(bytes, path)?;
    let has_words = text.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    match stated {
        _ if has_words => lines(&lenient_text(bytes, path)?, path, reading),
        Some(count) => binary(bytes, count, reading).map_err(|flaw| flaw.of(path)),
        None => {
            let found = bytes.len();
            let problem =
                format!("the file does not begin with `solid`, and has only {found} of the {HEADER} bytes of a header");
            Err(FormatError(problem).of(path))
        }
    }
}

fn binary(bytes: &[u8], count: u32, reading: Reading) -> Result<Raw, FormatError> {
    let mut bytes = Bytes::from(bytes, HEADER);
    let fit = bytes.left() / TRIANGLE;
    // A count smaller than the data would drop the rest of the mesh.
    if count as usize != fit {
        let problem =
            format!("the header declares {count} triangles of {TRIANGLE} bytes, and {} bytes follow", bytes.left());
        return Err(FormatError::at(HEADER - 4, &problem));
    }
    reading.capacity.check(count.into())?;
    let mut raw = Raw::default();
    for _ in 0..count {
        reading.stage.reach(bytes.at as f64);
        bytes.take::<12>()?;
        for _ in 0..3 {
            let at = bytes.at;
            let mut point = [0.0; 3];
            for value in &mut point {
                *value = f32::from_le_bytes(bytes.take()?);
            }
            if !point.into_iter().all(usable) {
                return Err(FormatError::at(
                    at,
                    &format!("a corner is at {point:?}; numbers must be finite, up to 1e30 in magnitude"),
                ));
            }
            raw.positions.push(Vec3::from_array(point).as_dvec3());
        }
        bytes.take::<2>()?;
        face(&mut raw, 3);
    }
    if raw.is_empty() { Err(FormatError(raw.nothing())) } else { Ok(raw) }
}

fn lines(text: &str, path: &Path, reading: Reading) -> Result<Raw, SceneError> {
    let mut raw = Raw::default();
    let mut mistakes = Diagnostics::of(text, path);
    let (mut corners, mut line) = (0, Vec::new());
    for text in text.lines() {
        line.clear();
        line.extend(words(text));
        reading.stage.advance(text.len() as f64);
        if let Err(wrong) = statement(&mut raw, &mut corners, &line) {
            mistakes.add(wrong);
        }
        if mistakes.are_enough() {
            break;
        }
        reading.capacity.check(raw.triangles().len() as u64).map_err(|flaw| flaw.of(path))?;
    }
    if corners > 0 && !mistakes.are_enough() {
        let problem = "the file ends inside a loop".to_owned();
        mistakes.add((&text[text.len()..], problem, "end the loop with `endloop`".to_owned()));
    }
    mistakes.or(
        raw,
        "a face consists of `facet`, `outer loop`, three lines such as `vertex 0 0 1`, `endloop` and `endfacet`",
    )
}

/// Reads one line; `corners` is the number of corners of the current loop.
fn statement<'a>(raw: &mut Raw, corners: &mut usize, line: &[&'a str]) -> Result<(), Wrong<'a>> {
    const KNOWN: [&str; 6] = ["solid", "endsolid", "facet", "endfacet", "outer", "endloop"];
    let Some(first) = line.first() else { return Ok(()) };
    if first.eq_ignore_ascii_case("vertex") {
        *corners += 1;
        let point = numbers(line);
        raw.positions.push(point.as_ref().map_or(DVec3::ZERO, |point| DVec3::from_array(*point)));
        return point.map(|_| ());
    }
    if !KNOWN.iter().any(|known| first.eq_ignore_ascii_case(known)) {
        let help = format!("valid lines begin with {}, vertex", KNOWN.join(", "));
        return Err((first, format!("unknown keyword `{first}`"), help));
    }
    if !first.eq_ignore_ascii_case("endloop") && *corners > 0 {
        *corners = 0;
        return Err((first, format!("`{first}` inside a loop"), "end the loop with `endloop`".to_owned()));
    }
    if first.eq_ignore_ascii_case("endloop") {
        let count = std::mem::take(corners);
        if count < 3 {
            return Err((first, format!("a loop has {count} vertices"), "a face requires three".to_owned()));
        }
        if count > MOST_CORNERS {
            let (problem, help) = too_many(count);
            return Err((first, problem, help));
        }
        face(raw, count);
    }
    Ok(())
}

/// Adds a face of the last `count` positions.
fn face(raw: &mut Raw, count: usize) {
    let end = raw.positions.len() as u32;
    let corners: Vec<Corner> = (end - count as u32..end).map(|i| Corner::new(i, None, None)).collect();
    raw.face(&corners);
}
