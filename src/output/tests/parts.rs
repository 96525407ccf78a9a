//! Tests of images that are cut into parts and merged again.

use std::{fs, path::Path};

use proptest::prelude::*;
use tempfile::TempDir;

use super::{folder, names};
use crate::output::{FileSettings, merge, open};
use crate::program::Layer;
use crate::render::{Band, Plane, Window};

/// Returns the part of an image in a window, with distinct values in every plane.
fn band(window: Window) -> Band {
    let Window { origin: [left, top], size: [width, rows] } = window;
    let word = |i: u32, seed: u32| {
        let (x, y) = (left + i % width, top + i / width);
        0x3f80_0000 ^ (y * 4001 + x).wrapping_mul(77_777).wrapping_add(seed * 1_234_567)
    };
    let words = |seed: u32| (0..width * rows).map(move |i| word(i, seed));
    let plane = |seed: u32| words(seed).map(f32::from_bits).collect::<Vec<f32>>();
    let layers = vec![(Layer::Position, Plane::Vector([5, 6, 7].map(plane))), (Layer::Object, Plane::Scalar(plane(8)))];
    Band { first_row: 0, rows, width, color: [1, 2, 3].map(plane), alpha: Some(plane(4)), layers }
}

fn settings(size: [u32; 2], window: Window) -> FileSettings {
    FileSettings {
        window,
        alpha: true,
        layers: vec![Layer::Position, Layer::Object],
        metadata: vec![("method".to_owned(), "två".to_owned()), ("Software".to_owned(), "bentray".to_owned())],
        ..FileSettings::new(size)
    }
}

fn write(path: &Path, settings: &FileSettings, band: &Band) {
    let mut writer = open(path, settings).unwrap();
    writer.write_band(band).unwrap();
    writer.finish().unwrap();
}

fn window(origin: [u32; 2], size: [u32; 2]) -> Window {
    Window { origin, size }
}

/// Writes these parts of an image of 40 by 50 to a folder, and merges them.
fn assembled(
    windows: &[Window],
    change: impl Fn(usize, &mut FileSettings, &mut Band),
) -> (TempDir, Result<(), String>) {
    let folder = folder();
    let mut paths = Vec::new();
    for (i, &window) in windows.iter().enumerate() {
        let (mut settings, mut band) = (settings([40, 50], window), band(window));
        change(i, &mut settings, &mut band);
        let path = folder.path().join(format!("part{i}.exr"));
        write(&path, &settings, &band);
        paths.push(path);
    }
    let result = merge(&paths, &[folder.path().join("whole.exr")]).map_err(|error| error.to_string());
    (folder, result)
}

fn unchanged(_: usize, _: &mut FileSettings, _: &mut Band) {}

/// Returns windows that cover an image: a randomly split rectangle with some of the pieces enlarged over their neighbors.
fn cuts(size: [u32; 2]) -> impl Strategy<Value = Vec<Window>> {
    let cut = (any::<prop::sample::Index>(), any::<bool>(), any::<prop::sample::Index>(), 0..4_u32);
    prop::collection::vec(cut, 0..8).prop_map(move |cuts| {
        let mut windows = vec![Window::whole(size)];
        for (which, across, place, more) in cuts {
            let at = which.index(windows.len());
            let (k, old) = (usize::from(across), windows[at]);
            if old.size[k] < 2 {
                continue;
            }
            let first = 1 + place.index(old.size[k] as usize - 1) as u32;
            let mut second = old;
            second.origin[k] += first;
            second.size[k] -= first;
            windows[at].size[k] = (first + more).min(old.size[k]);
            windows.push(second);
        }
        windows.reverse();
        windows
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Checks that the merged file equals the whole image's file for any cut and order.
    #[test]
    fn parts_make_the_whole_to_the_byte(windows in cuts([40, 50])) {
        let (folder, result) = assembled(&windows, unchanged);
        prop_assert_eq!(result, Ok(()), "{:?}", windows);
        let whole = Window::whole([40, 50]);
        write(&folder.path().join("expected.exr"), &settings([40, 50], whole), &band(whole));
        let [made, expected] = ["whole.exr", "expected.exr"].map(|name| fs::read(folder.path().join(name)).unwrap());
        prop_assert!(made == expected, "{:?}", windows);
    }

    /// Checks that a missing part is reported and nothing is written, unless other parts cover it.
    #[test]
    fn a_missing_part_is_named(windows in cuts([40, 50]), lost in any::<prop::sample::Index>()) {
        let mut rest = windows.clone();
        let lost = rest.remove(lost.index(windows.len()));
        prop_assume!(!rest.is_empty());
        let covered = |x, y| rest.iter().any(|w| {
            (w.origin[0]..w.origin[0] + w.size[0]).contains(&x) && (w.origin[1]..w.origin[1] + w.size[1]).contains(&y)
        });
        let [left, top] = lost.origin;
        let mut pixels = (top..top + lost.size[1]).flat_map(|y| (left..left + lost.size[0]).map(move |x| (x, y)));
        let first = pixels.find(|&(x, y)| !covered(x, y));
        let (folder, result) = assembled(&rest, unchanged);
        match first {
            None => prop_assert_eq!(result, Ok(())),
            Some((x, y)) => {
                let message = result.unwrap_err();
                let place = format!("the parts leave a gap at column {x}, row {y}: render it with --crop {x},{y},");
                prop_assert!(message.contains(&place), "{}", message);
                prop_assert!(!names(folder.path()).contains(&"whole.exr".into()));
            }
        }
    }
}

type Change = fn(usize, &mut FileSettings, &mut Band);

#[test]
fn parts_that_do_not_belong_together_are_refused() {
    let halves = [window([0, 0], [40, 30]), window([0, 25], [40, 25])];
    let cases: [(Change, &str); 5] = [
        (|i, settings, _| settings.size[0] += i as u32, "part1.exr: this is a part of an image of 41x50 pixels, but "),
        (|i, settings, _| settings.layers.truncate(2 - i), "part1.exr: its layers differ from those of "),
        (|i, settings, _| settings.alpha = i == 0, "part1.exr: its layers differ from those of "),
        (
            |i, settings, _| settings.metadata[0].1 = ["rk4", "euler"][i].to_owned(),
            "part1.exr: its `method` is `euler`, but that of ",
        ),
        (|i, settings, _| settings.metadata.truncate(2 - i), "part1.exr: its `Software` is nothing, but that of "),
    ];
    for (change, message) in cases {
        let (folder, result) = assembled(&halves, change);
        let said = result.unwrap_err();
        assert!(said.contains(message), "{said}");
        assert_eq!(names(folder.path()).len(), 2);
    }
}

/// Checks that one bit, such as the sign of a zero or a bit of a NaN, counts as a difference.
#[test]
fn overlaps_that_disagree_are_refused() {
    let halves = [window([0, 0], [40, 30]), window([7, 25], [33, 25]), window([0, 28], [7, 22])];
    for (at, column, row) in [(0, 7, 25), (33 + 4, 11, 26)] {
        let (folder, result) = assembled(&halves, |i, _, band| {
            if i == 1 {
                let bits = &mut band.color[1][at];
                *bits = f32::from_bits(bits.to_bits() ^ 1);
            }
        });
        let said = result.unwrap_err();
        let place = format!("part0.exr disagree at column {column}, row {row}: ");
        assert!(said.contains("part1.exr and ") && said.contains(&place), "{said}");
        assert_eq!(names(folder.path()).len(), 3);
    }
}

/// Checks that an incomplete or foreign EXR is reported and the output is unchanged.
#[test]
fn broken_files_are_refused() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    let whole = Window::whole([40, 50]);
    write(&path("part.exr"), &settings([40, 50], whole), &band(whole));
    fs::write(path("whole.exr"), "an old whole").unwrap();
    let bytes = fs::read(path("part.exr")).unwrap();
    for length in [0, 3, 100, 500, bytes.len() / 2, bytes.len() - 1] {
        fs::write(path("short.exr"), &bytes[..length]).unwrap();
        let said = merge(&[path("short.exr")], &[path("whole.exr")]).unwrap_err().to_string();
        assert!(said.contains("short.exr: "), "{length}: {said}");
    }
    for name in ["short.exr", "nothing.exr"] {
        let _ = fs::remove_file(path(name));
        let said = merge(&[path(name)], &[path("whole.exr")]).unwrap_err().to_string();
        assert!(said.contains("cannot read the file"), "{said}");
    }
    assert_eq!(fs::read(path("whole.exr")).unwrap(), b"an old whole");
}
