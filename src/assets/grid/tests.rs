//! Tests of sample files: the contents of valid files, and the errors of invalid ones.

use super::{GridUse, RawGridLayout, SampledGrid, Stored};
use crate::document::{Diagnostic, SceneError};
use crate::progress::Progress;
use glam::DVec3;
use proptest::prelude::*;
use std::io::Write as _;
use std::path::Path;

const AS_IT_IS: GridUse = GridUse { bare: None, corners: None, scale: 1.0, offset: 0.0, is_index: true };
const HEADER: &str = "NRRD0004\n# made by hand\ntype: float\ndimension: 3\nsizes: 2 3 2\nencoding: raw\nendian: little\n\
                      spacings: 0.5 1 2\nkey:=value\ncontent: a: b\n";

fn values() -> Vec<f32> {
    (0_u8..12).map(|i| 1.0 + f32::from(i) / 8.0).collect()
}

fn bytes<const N: usize>(of: fn(f32) -> [u8; N]) -> Vec<u8> {
    values().into_iter().flat_map(of).collect()
}

fn load(header: &str, data: &[u8], used: &GridUse) -> Result<SampledGrid, SceneError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.nrrd");
    std::fs::write(&path, [header.as_bytes(), data].concat()).unwrap();
    SampledGrid::load(&path, used)
}

fn good(header: &str, data: &[u8]) -> SampledGrid {
    load(&format!("{header}\n"), data, &AS_IT_IS).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_header_says_where_samples_are() {
    let data = bytes(f32::to_le_bytes);
    let grid = good(HEADER, &data);
    assert_eq!((grid.size, grid.samples), ([2, 3, 2], values()));
    assert_eq!((grid.origin, grid.cell), (DVec3::ZERO, DVec3::new(0.5, 1.0, 2.0)));
    let header = HEADER.replace(
        "spacings: 0.5 1 2",
        "space: right-anterior-superior\r\nspace directions: (1,0,0) (0, 2, 0) (0,0,.5)\nspace origin: (-1, 2,3)",
    );
    let grid = good(&header, &data);
    assert_eq!((grid.origin, grid.cell), (DVec3::new(-1.0, 2.0, 3.0), DVec3::new(1.0, 2.0, 0.5)));
    // The scene has priority over the file.
    let used = GridUse { corners: Some([DVec3::splat(-1.0), DVec3::splat(1.0)]), ..AS_IT_IS };
    let grid = load(&format!("{header}\n"), &data, &used).unwrap();
    assert_eq!((grid.origin, grid.cell), (DVec3::splat(-1.0), DVec3::new(2.0, 1.0, 2.0)));
}

#[test]
fn every_kind_of_number_is_read() {
    let little = ["endian: little", "endian: big"];
    for (name, data) in [
        ("float", [bytes(f32::to_le_bytes), bytes(f32::to_be_bytes)]),
        ("double", [bytes(|v| f64::from(v).to_le_bytes()), bytes(|v| f64::from(v).to_be_bytes())]),
        ("unsigned short", [bytes(|v| ((8.0 * v) as u16).to_le_bytes()), bytes(|v| ((8.0 * v) as u16).to_be_bytes())]),
        ("uint8", [bytes(|v| [(8.0 * v) as u8]), bytes(|v| [(8.0 * v) as u8])]),
        ("unsigned int", [bytes(|v| ((8.0 * v) as u32).to_le_bytes()), bytes(|v| ((8.0 * v) as u32).to_be_bytes())]),
        ("uint64", [bytes(|v| ((8.0 * v) as u64).to_le_bytes()), bytes(|v| ((8.0 * v) as u64).to_be_bytes())]),
        ("int8", [bytes(|v| ((-8.0 * v) as i8).to_le_bytes()), bytes(|v| ((-8.0 * v) as i8).to_be_bytes())]),
        ("short", [bytes(|v| ((-8.0 * v) as i16).to_le_bytes()), bytes(|v| ((-8.0 * v) as i16).to_be_bytes())]),
        ("int32_t", [bytes(|v| ((-8.0 * v) as i32).to_le_bytes()), bytes(|v| ((-8.0 * v) as i32).to_be_bytes())]),
        ("long long", [bytes(|v| ((-8.0 * v) as i64).to_le_bytes()), bytes(|v| ((-8.0 * v) as i64).to_be_bytes())]),
    ] {
        let scale = match name {
            "float" | "double" => 1.0,
            unsigned if unsigned.starts_with('u') => 0.125,
            _ => -0.125,
        };
        for (endian, data) in little.iter().zip(data) {
            let header = HEADER.replace("type: float", &format!("type: {name}")).replace("endian: little", endian);
            let used = GridUse { scale: 2.0 * scale, offset: -1.0, ..AS_IT_IS };
            let want: Vec<f32> = values().iter().map(|v| 2.0 * v - 1.0).collect();
            assert_eq!(load(&format!("{header}\n"), &data, &used).unwrap().samples, want, "{name}, {endian}");
            let mut zipper = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
            zipper.write_all(&data).unwrap();
            let zipped = header.replace("encoding: raw", "encoding: gzip");
            let found = load(&format!("{zipped}\n"), &zipper.finish().unwrap(), &used).unwrap();
            assert_eq!(found.samples, want, "{name}, {endian}, by gzip");
        }
    }
}

#[test]
fn samples_may_be_in_a_file_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    let header = HEADER.replace("content: a: b", "data file: ./the samples.raw");
    let data = folder.path().join("the samples.raw");
    for ending in ["", "\n"] {
        let path = folder.path().join("a.nhdr");
        std::fs::write(&path, header.clone() + ending).unwrap();
        std::fs::write(&data, bytes(f32::to_le_bytes)).unwrap();
        let grid = SampledGrid::load(&path, &AS_IT_IS).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!((grid.samples, grid.data), (values(), Some(folder.path().join("./the samples.raw"))));
        let mut zipper = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        zipper.write_all(&bytes(f32::to_le_bytes)).unwrap();
        std::fs::write(&path, header.replace("encoding: raw", "encoding: gzip")).unwrap();
        std::fs::write(&data, zipper.finish().unwrap()).unwrap();
        assert_eq!(SampledGrid::load(&path, &AS_IT_IS).unwrap().samples, values());
    }
}

/// Skipped lines come first and are never packed; bytes are counted after unpacking.
#[test]
fn samples_may_follow_lines_and_bytes_that_are_none() {
    let zip = |data: &[u8]| {
        let mut zipper = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        zipper.write_all(data).unwrap();
        zipper.finish().unwrap()
    };
    let (samples, lines) = (bytes(f32::to_le_bytes), b"a scan\r\nof a\rhead\n".as_slice());
    let after = |front: &[u8]| [front, &samples].concat();
    for (fields, encoding, data) in [
        ("byte skip: 5\n", "raw", after(b"\n\n\n\n\n")),
        ("line skip: 3\n", "raw", after(lines)),
        ("lineskip: 3\nbyteskip: 2\n", "raw", [lines, &after(b"\0\n")].concat()),
        ("byte skip: -1\n", "raw", after(&[7; 1000])),
        ("byte skip: -1\n", "raw", samples.clone()),
        ("line skip: 1\nbyte skip: -1\n", "raw", after(lines)),
        ("byte skip: 5\n", "gzip", zip(&after(b"\0\0\0\0\0"))),
        ("line skip: 3\nbyte skip: 2\n", "gzip", [lines, &zip(&after(b"ab"))].concat()),
    ] {
        let header = HEADER.replace("encoding: raw", &format!("encoding: {encoding}")) + fields;
        assert_eq!(good(&header, &data).samples, values(), "{fields}{encoding}, attached");
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.nhdr");
        std::fs::write(&path, header + "data file: a.raw\n").unwrap();
        std::fs::write(folder.path().join("a.raw"), data).unwrap();
        let grid = SampledGrid::load(&path, &AS_IT_IS).unwrap_or_else(|error| panic!("{fields}{encoding}: {error}"));
        assert_eq!(grid.samples, values(), "{fields}{encoding}, detached");
    }
    for (fields, front, found) in [("byte skip: 5\n", 6, 49), ("byte skip: 5\n", 4, 47), ("byte skip: 1000000\n", 0, 0)]
    {
        let error = load(&format!("{HEADER}{fields}\n"), &after(&vec![0; front]), &AS_IT_IS).unwrap_err().to_string();
        assert!(
            error.contains(&format!(
                "the file has {found} bytes of samples, and [2, 3, 2] samples of 4 bytes require 48"
            )),
            "{error}"
        );
    }
}

#[test]
fn samples_are_reported_as_they_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.nrrd");
    std::fs::write(&path, [HEADER.as_bytes(), b"\n", &bytes(f32::to_le_bytes)].concat()).unwrap();
    let progress = Progress::watched();
    let stage = progress.measured("reading", 1.0);
    SampledGrid::read(&path, &AS_IT_IS, &stage).unwrap();
    assert_eq!(progress.state().and_then(|state| state.done), Some(1.0));
}

#[test]
fn bare_numbers_need_what_the_scene_says() {
    let bare = RawGridLayout { size: [3, 2, 2], stored: Stored::F64, little: false };
    let corners = Some([DVec3::ZERO, DVec3::ONE]);
    let data = bytes(|v| f64::from(v).to_be_bytes());
    let grid = load("", &data, &GridUse { bare: Some(bare), corners, ..AS_IT_IS }).unwrap();
    assert_eq!((grid.samples, grid.cell), (values(), DVec3::new(0.5, 1.0, 1.0)));
}

/// In a header «» marks the location of the error.
#[test]
fn mistakes_have_their_line() {
    let mark = |from: &str, to: &str| HEADER.replace(from, to);
    for (marked, problem) in [
        ("«P5»\n2 2\n".to_owned(), "not a NRRD file"),
        (mark("# made by hand", "«made by hand»"), "expected `field: value`"),
        (mark("type: float", "type: «block»"), "samples of type `block` are not supported"),
        (mark("dimension: 3", "dimension: «2»"), "three-dimensional volumes"),
        (mark("sizes: 2 3 2", "sizes: «2 3»"), "expected three sizes"),
        (mark("sizes: 2 3 2", "sizes: «2 -3 2»"), "expected three sizes"),
        (mark("encoding: raw", "encoding: «bzip2»"), "the encoding `bzip2` is not supported"),
        (mark("endian: little", "endian: «middle»"), "unknown endianness"),
        (mark("NRRD0004", "«NRRD0004»").replace("endian: little\n", ""), "the header has no `endian`"),
        (mark("NRRD0004", "«NRRD0004»").replace("sizes: 2 3 2\n", ""), "the header has no `sizes`"),
        (mark("spacings: 0.5 1 2", "spacings: 0.5 1 2\n«Sizes: 2 3 2»"), "`sizes` is defined twice"),
        (mark("spacings: 0.5 1 2", "spacings: «0.5 nan 2»"), "expected three spacings"),
        (mark("spacings: 0.5 1 2", "spacings: «0.5 0 2»"), "expected three spacings"),
        (
            mark("spacings: 0.5 1 2", "space directions: «(1,0,0) (0,1,0.1) (0,0,1)»"),
            "the directions must be along x, y and z",
        ),
        (mark("spacings: 0.5 1 2", "space directions: «none (0,1,0) (0,0,1)»"), "expected three directions"),
        (mark("content: a: b", "space origin: «0 0 0»"), "expected a position"),
        (mark("content: a: b", "data file: «LIST»"), "samples in several files are not supported"),
        (mark("content: a: b", "data file: «LIST 2»"), "samples in several files are not supported"),
        (mark("content: a: b", "datafile: «a%03d.raw 1 10 1»"), "samples in several files are not supported"),
        (mark("content: a: b", "data file: «b.raw»"), "does not exist"),
        // The file is the header itself, which has a different length.
        (mark("content: a: b", "data file: «a.nrrd»"), "the file has "),
        (mark("content: a: b", "byte skip: «-2»"), "expected a number of bytes, found `-2`"),
        (mark("content: a: b", "byte skip: «1.5»"), "expected a number of bytes, found `1.5`"),
        (mark("content: a: b", "line skip: «-1»"), "expected a number of lines, found `-1`"),
        (mark("content: a: b", "line skip: «2»"), "the data has only 0 lines"),
        (mark("content: a: b", "byteskip: «-1»").replace("raw", "gzip"), "is valid only for uncompressed samples"),
    ] {
        let start = marked.find('«').unwrap();
        let end = marked.find('»').unwrap() - '«'.len_utf8();
        let text = marked.replace(['«', '»'], "");
        let Err(SceneError::Diagnostics(mistakes)) = load(&format!("{text}\n"), &[0; 48], &AS_IT_IS) else {
            panic!("{text}")
        };
        let [Diagnostic { line, excerpt, problem: said, .. }] = &mistakes[..] else { panic!("{text}") };
        assert_eq!((*line, excerpt.as_str()), (text[..start].split('\n').count(), &text[start..end]), "{said}");
        assert!(said.contains(problem), "{said}");
    }
}

#[test]
fn samples_that_cannot_be_used_are_refused() {
    let data = bytes(f32::to_le_bytes);
    let with = |i: usize, v: f32| {
        let mut all = data.clone();
        all[4 * i..4 * i + 4].copy_from_slice(&v.to_le_bytes());
        all
    };
    for (header, data, problem) in [
        (
            HEADER.to_owned(),
            data[..40].to_vec(),
            "the file has 40 bytes of samples, and [2, 3, 2] samples of 4 bytes require 48",
        ),
        (
            HEADER.to_owned(),
            with(9, -2.0),
            "sample [1, 1, 1], counted from 0, is -2 and makes n = -2, which must be above 0",
        ),
        (HEADER.to_owned(), with(4, f32::NAN), "sample [0, 2, 0], counted from 0, is NaN"),
        (HEADER.replace("2 3 2", "1 6 2"), data.clone(), "at least two are required along each axis"),
        (HEADER.replace("2 3 2", "4294967295 4294967295 4294967295"), data.clone(), "more than 2^30 samples"),
        (
            HEADER.replace("spacings: 0.5 1 2\n", ""),
            data.clone(),
            "the position of the grid is unknown: give `min` and `max`",
        ),
        (HEADER.replace("raw", "gzip"), data.clone(), "the samples cannot be decompressed"),
    ] {
        let error = load(&format!("{header}\n"), &data, &AS_IT_IS).unwrap_err().to_string();
        assert!(error.contains(problem) && error.contains("a.nrrd"), "{error}");
    }
    assert!(matches!(SampledGrid::load(Path::new("none.nrrd"), &AS_IT_IS), Err(SceneError::Read { .. })));
}

proptest! {
    #[test]
    fn damaged_headers_do_not_panic(at in 0..HEADER.len(), piece in "[-a0.(),:\n é]{0,3}", cut in 0..60_usize) {
        let text: String = HEADER.chars().enumerate().map(|(i, c)| if i == at { piece.clone() } else { c.to_string() }).collect();
        let data = bytes(f32::to_le_bytes);
        if let Ok(grid) = load(&format!("{text}\n"), &data[..data.len().min(cut)], &AS_IT_IS) {
            prop_assert_eq!(grid.samples.len(), grid.size.iter().product::<u32>() as usize);
        }
    }
}
