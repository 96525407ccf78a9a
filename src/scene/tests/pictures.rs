//! Tests of image colors: the color information of a file is applied or reported.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, Vec2, WritableImage,
    attribute::Chromaticities,
};
use image::{ImageEncoder, Rgb, Rgb32FImage};

use crate::scene::Picture;

/// ACES2065-1 to linear Rec. 709 with Bradford adaptation, as published with the ACES configurations of `OpenColorIO`.
const FROM_ACES: [[f64; 3]; 3] =
    [[2.521_686, -1.134_131, -0.387_555], [-0.276_480, 1.372_719, -0.096_239], [-0.015_378, -0.152_975, 1.168_353]];
/// Display P3 to linear Rec. 709, as published with CSS Color 4.
const FROM_P3: [[f64; 3]; 3] =
    [[1.224_940, -0.224_940, 0.0], [-0.042_057, 1.042_057, 0.0], [-0.019_638, -0.078_636, 1.098_274]];

fn times(matrix: [[f64; 3]; 3], color: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row.iter().zip(color).map(|(a, b)| a * b).sum())
}

fn load(path: &Path) -> Picture {
    Picture::load(path).unwrap_or_else(|error| panic!("{error}"))
}

/// Compares all pixels with one color.
fn shows(picture: &Picture, color: [f64; 3], tolerance: f64) {
    for pixel in picture.pixels.iter() {
        let near = pixel.iter().zip(color).all(|(a, b)| (f64::from(*a) - b).abs() <= tolerance * b.abs().max(0.1));
        assert!(near, "{}: {pixel:?} is not {color:?}", picture.name);
    }
}

fn in_folder(name: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    (folder, path)
}

/// Writes one color, with additional lines in its header.
fn hdr(path: &Path, color: [f32; 3], first: &str, lines: &str) {
    Rgb32FImage::from_pixel(3, 2, Rgb(color)).save(path).expect("saved");
    let plain = fs::read(path).expect("read");
    let begin = plain.iter().position(|byte| *byte == b'\n').expect("a line");
    let at = plain.windows(2).position(|pair| pair == b"\n\n").expect("a header") + 1;
    fs::write(path, [first.as_bytes(), &plain[begin..at], lines.as_bytes(), &plain[at..]].concat()).expect("written");
}

#[test]
fn what_an_hdr_file_was_multiplied_by_is_taken_out_of_it() {
    let (_folder, path) = in_folder("f.hdr");
    let stored = [0.5, 2.0, 8.0];
    for (first, lines, radiance) in [
        ("#?RGBE", "", [0.5, 2.0, 8.0]),
        ("#?RADIANCE", "COLORCORR=1 2 4\n", [0.5, 1.0, 2.0]),
        ("#?RADIANCE", "COLORCORR= 1 2 4\nEXPOSURE=2\r\nCOLORCORR=2 1 0.5\n", [0.125, 0.5, 2.0]),
        ("#?RADIANCE", "EXPOSURE= 4\nEXPOSURE=0.5\n", [0.25, 1.0, 4.0]),
        // The history of an earlier program.
        ("#?AUTOPANO11", "\tEXPOSURE=2\nSOFTWARE=a = b\n", [0.5, 2.0, 8.0]),
    ] {
        hdr(&path, stored, first, lines);
        let picture = load(&path);
        assert_eq!((&picture.notes[..], picture.size), (&[][..], [3, 2]));
        shows(&picture, radiance, 0.0);
    }
    hdr(&path, stored, "#?RADIANCE", "EXPOSURE=x\nCOLORCORR=1 2\nPRIMARIES=0 0 0 0 0 0 0 0\nPRIMARIES=1 2\n");
    let picture = load(&path);
    shows(&picture, [0.5, 2.0, 8.0], 0.0);
    let told = picture.notes.join("\n");
    for part in ["`EXPOSURE=x`", "`COLORCORR=1 2`", "the PRIMARIES are ignored", "`PRIMARIES=1 2`"] {
        assert!(told.contains(part), "{told}");
    }
    hdr(&path, stored, "#?RADIANCE", "FORMAT=32-bit_rle_xyze\n");
    let error = Picture::load(&path).expect_err("another format").to_string();
    assert!(error.contains("the FORMAT 32-bit_rle_xyze is not supported"), "{error}");
}

#[test]
fn rows_that_a_header_leaves_out_are_told() {
    let (_folder, path) = in_folder("f.hdr");
    hdr(&path, [0.5, 2.0, 8.0], "#?RADIANCE", "");
    let whole = fs::read(&path).expect("read");
    let at = whole.windows(4).position(|part| part == b"-Y 2").expect("a size");
    for (rows, behind, told) in
        [(b'1', &b""[..], true), (b'2', b"", false), (b'2', b"\0\0\n", false), (b'2', b"more", true)]
    {
        let mut bytes = [&whole[..], behind].concat();
        bytes[at + 3] = rows;
        fs::write(&path, bytes).expect("written");
        let notes = load(&path).notes.join("\n");
        assert_eq!(notes.contains("the data after them is ignored"), told, "{rows} {behind:?}: {notes}");
    }
}

/// Checks that a color with the ACES primaries is read identically from each format with chromaticities.
#[test]
fn primaries_become_those_of_rec_709() {
    // The values are quarters and eighths, which the four bytes of HDR represent exactly, and the color is inside Rec. 709.
    let color = [0.5, 0.625, 0.75];
    let expected = times(FROM_ACES, color);
    let (_folder, path) = in_folder("a.exr");
    let aces = Chromaticities {
        red: Vec2(0.7347, 0.2653),
        green: Vec2(0.0, 1.0),
        blue: Vec2(0.0001, -0.077),
        white: Vec2(0.32168, 0.33767),
    };
    let [r, g, b] = color.map(|x| x as f32);
    exr(&path, &[("R", r), ("G", g), ("B", b)], Some(aces));
    shows(&load(&path), expected, 1e-4);
    let (_folder, path) = in_folder("a.hdr");
    let line = "PRIMARIES=0.7347 0.2653 0 1 0.0001 -0.077 0.32168 0.33767\n";
    hdr(&path, [r, g, b], "#?RADIANCE", line);
    shows(&load(&path), expected, 1e-4);
    let picture = load(&path);
    assert!(picture.notes.is_empty(), "{:?}", picture.notes);
    // The green primary of ACES is outside Rec. 709: its red and blue are negative.
    hdr(&path, [0.0, 1.0, 0.0], "#?RADIANCE", line);
    let picture = load(&path);
    shows(&picture, [0.0, FROM_ACES[1][1], 0.0], 1e-4);
    assert!(picture.notes[0].contains("6 of its 6 pixels (100.00 %)"), "{:?}", picture.notes);
    // Chromaticities in a single point span no gamut.
    let none = Chromaticities { red: aces.white, green: aces.white, blue: aces.white, white: aces.white };
    let (_folder, path) = in_folder("a.exr");
    exr(&path, &[("R", r), ("G", g), ("B", b)], Some(none));
    let picture = load(&path);
    shows(&picture, color, 1e-6);
    assert!(picture.notes[0].contains("chromaticities are ignored"), "{:?}", picture.notes);
}

fn exr(path: &Path, channels: &[(&str, f32)], chromaticities: Option<Chromaticities>) {
    let channel = |(name, value): &(&str, f32)| AnyChannel::new(*name, FlatSamples::F32(vec![*value; 6]));
    let channels = AnyChannels::sort(channels.iter().map(channel).collect());
    let layer = Layer::new((3, 2), LayerAttributes::default(), Encoding::UNCOMPRESSED, channels);
    let mut image = Image::from_layer(layer);
    image.attributes.chromaticities = chromaticities;
    image.write().to_file(path).expect("written");
}

#[test]
fn channels_of_an_exr_are_found_by_their_names() {
    let (_folder, path) = in_folder("a.exr");
    for (channels, color) in [
        (&[("Y", 0.25)][..], [0.25; 3]),
        (&[("A", 0.5), ("y", 0.25)], [0.25; 3]),
        (&[("r", 0.5), ("g", 2.0), ("b", 8.0)], [0.5, 2.0, 8.0]),
        (&[("l.Y", 0.25), ("l.A", 1.0)], [0.25; 3]),
        (&[("V.Combined.R", 0.5), ("V.Combined.G", 2.0), ("V.Combined.B", 8.0), ("V.Depth.Z", 9.0)], [0.5, 2.0, 8.0]),
        (
            &[("a.DiffCol.R", 1.0), ("a.DiffCol.G", 1.0), ("a.DiffCol.B", 1.0)]
                .into_iter()
                .chain([("a.Combined.R", 0.5), ("a.Combined.G", 2.0), ("a.Combined.B", 8.0)])
                .collect::<Vec<_>>(),
            [0.5, 2.0, 8.0],
        ),
        (&[("R", 0.5), ("G", 2.0), ("B", 8.0), ("x.R", 1.0), ("x.G", 1.0), ("x.B", 1.0)], [0.5, 2.0, 8.0]),
    ] {
        exr(&path, channels, None);
        shows(&load(&path), color, 0.0);
    }
    for (channels, parts) in [
        (&[("Y", 1.0), ("RY", 0.0), ("BY", 0.0)][..], ["`BY`, `RY`, `Y`", "luminance-chroma channels"]),
        (&[("N.X", 1.0), ("N.Y", 0.0), ("N.Z", 0.0)], ["`N.X`, `N.Y`, `N.Z`", "expected `R`, `G` and `B`"]),
        (
            &[("a.R", 1.0), ("a.G", 1.0), ("a.B", 1.0), ("b.R", 1.0), ("b.G", 1.0), ("b.B", 1.0)],
            ["`a.R`", "or in a layer called `Combined`"],
        ),
    ] {
        exr(&path, channels, None);
        let error = Picture::load(&path).expect_err("refused").to_string();
        assert!(parts.iter().all(|part| error.contains(part)), "{error}");
    }
    // Chroma is usually stored for every second pixel, which this library cannot write.
    exr(&path, &[("Y", 1.0), ("RY", 0.0), ("BY", 0.0)], None);
    let mut bytes = fs::read(&path).expect("read");
    for name in [&b"BY\0"[..], b"RY\0"] {
        let at = bytes.windows(3).position(|three| three == name).expect("the channel") + name.len();
        bytes[at + 8] = 2;
        bytes[at + 12] = 2;
    }
    fs::write(&path, bytes).expect("written");
    let error = Picture::load(&path).expect_err("refused").to_string();
    assert!(error.contains("`BY`, `RY`, `Y`; luminance-chroma channels"), "{error}");
}

/// Writes a PNG of one color with these chunks.
fn png(path: &Path, color: [u8; 3], chunks: &[(&[u8; 4], Vec<u8>)]) {
    let mut encoder = png::Encoder::new(fs::File::create(path).expect("created"), 2, 1);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("a header");
    for (name, bytes) in chunks {
        writer.write_chunk(png::chunk::ChunkType(**name), bytes).expect("a chunk");
    }
    writer.write_image_data(&[color, color].concat()).expect("pixels");
    writer.finish().expect("an end");
}

/// Returns numbers in units of 1e-5.
fn scaled(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|x| ((x * 1e5).round() as u32).to_be_bytes()).collect()
}

fn profile_chunk(profile: &[u8]) -> Vec<u8> {
    let mut packed = flate2::write::ZlibEncoder::new(b"a profile\0\0".to_vec(), flate2::Compression::fast());
    packed.write_all(profile).expect("packed");
    packed.finish().expect("packed")
}

#[test]
fn what_a_png_says_of_its_colors_is_applied() {
    let (_folder, path) = in_folder("a.png");
    let stored = [64, 128, 192];
    let units = stored.map(|x| f64::from(x) / 255.0);
    let srgb = units.map(|x| ((x + 0.055) / 1.055_f64).powf(2.4));
    let p3 = [0.3127, 0.329, 0.68, 0.32, 0.265, 0.69, 0.15, 0.06];
    let gamma = |x: f64| (b"gAMA", scaled(&[x]));
    let of_p3 = moxcms::ColorProfile::new_display_p3().encode().expect("a profile");
    let of_srgb = moxcms::ColorProfile::new_srgb().encode().expect("a profile");
    for (chunks, color, tolerance) in [
        (vec![], srgb, 1e-6),
        (vec![gamma(1.0)], units, 1e-6),
        (vec![gamma(0.5)], units.map(|x| x * x), 1e-6),
        (vec![(b"cHRM", scaled(&p3))], times(FROM_P3, srgb), 1e-4),
        (vec![gamma(1.0), (b"cHRM", scaled(&p3))], times(FROM_P3, units), 1e-4),
        (vec![(b"sRGB", vec![0]), gamma(1.0), (b"cHRM", scaled(&p3))], srgb, 1e-6),
        // The numbers of profiles are fixed-point with 16 bits.
        (vec![(b"iCCP", profile_chunk(&of_p3)), gamma(1.0)], times(FROM_P3, srgb), 2e-3),
        (vec![(b"iCCP", profile_chunk(&of_srgb)), gamma(1.0)], srgb, 1e-3),
        (vec![(b"cICP", vec![12, 8, 0, 1]), (b"sRGB", vec![0])], times(FROM_P3, units), 1e-4),
    ] {
        png(&path, stored, &chunks);
        let picture = load(&path);
        assert!(picture.notes.is_empty(), "{:?}", picture.notes);
        shows(&picture, color, tolerance);
    }
    for (chunk, note) in [
        (gamma(0.0), "the gAMA chunk is malformed and ignored"),
        ((b"cHRM", scaled(&[0.3, 0.3, 0.5, 0.3, 0.5, 0.3, 0.5, 0.3])), "chromaticities (cHRM) are ignored"),
        ((b"iCCP", profile_chunk(&[1; 200])), "the ICC profile is ignored, because it cannot be read"),
        ((b"iCCP", b"no zeros".to_vec()), "the iCCP chunk is malformed"),
        ((b"cICP", vec![9, 16, 0, 1]), "the code points (cICP 9, 16, 0, 1) are ignored"),
    ] {
        png(&path, stored, &[chunk]);
        let picture = load(&path);
        assert!(picture.notes.len() == 1 && picture.notes[0].contains(note), "{:?}", picture.notes);
        shows(&picture, srgb, 1e-6);
    }
}

#[test]
fn the_profile_of_a_jpeg_is_applied_or_told() {
    let (_folder, path) = in_folder("a.jpg");
    let write = |profile: Vec<u8>| {
        let mut encoder =
            image::codecs::jpeg::JpegEncoder::new_with_quality(fs::File::create(&path).expect("a file"), 100);
        encoder.set_icc_profile(profile).expect("a profile");
        encoder.write_image(&[128; 192], 8, 8, image::ExtendedColorType::Rgb8).expect("written");
    };
    // Gray, which does not depend on primaries, with another curve: Adobe RGB's 2.2.
    write(moxcms::ColorProfile::new_adobe_rgb().encode().expect("a profile"));
    let picture = load(&path);
    assert!(picture.notes.is_empty(), "{:?}", picture.notes);
    shows(&picture, [(128.0_f64 / 255.0).powf(2.199_218_75); 3], 2e-3);
    write(vec![7; 300]);
    let picture = load(&path);
    assert!(picture.notes[0].contains("the ICC profile is ignored"), "{:?}", picture.notes);
}

#[test]
fn other_formats_are_named() {
    let (_folder, path) = in_folder("a.png");
    for (bytes, name) in [
        (&b"RIFF\x08\0\0\0WEBPVP8 "[..], "the image is in the format WebP: convert it to PNG, JPEG, EXR or HDR"),
        (b"\xabKTX 20\xbb\r\n\x1a\n", "the image is in the format KTX"),
        (b"GIF89a", "the image is in the format GIF"),
        (b"II*\0", "the image is in the format TIFF"),
        (b"nothing", "the image is in an unknown format"),
        (b"", "the image is empty"),
    ] {
        fs::write(&path, bytes).expect("written");
        let error = Picture::load(&path).expect_err("refused").to_string();
        assert!(error.contains(name), "{error}");
    }
}
