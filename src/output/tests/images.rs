//! Tests that read written images.

#![allow(clippy::float_cmp)] // values that are stored exactly are compared exactly

use std::{collections::BTreeMap, fs, io::BufReader, path::Path};

use ::exr::prelude::{FlatSamples, read_first_flat_layer_from_file};

use super::{folder, names};
use crate::output::band::{channels, components};
use crate::output::{
    FileSettings, OutputError,
    color::{SrgbBytes, display, srgb_from_linear, tonemapped},
    open, picture, settings_of,
};
use crate::program::Layer;
use crate::render::{Band, Plane, Window};
use crate::scene::Tonemap;

/// Returns an image with distinct values, as bands of these heights.
fn bands(width: u32, heights: &[u32]) -> Vec<Band> {
    let mut first_row = 0;
    let mut bands = Vec::new();
    for &rows in heights {
        let pixels = first_row * width..(first_row + rows) * width;
        let plane = |seed: u32| -> Vec<f32> {
            let value = |i: u32| f32::from_bits(0x3f80_0000 ^ (i * 77_777 + seed * 1_234_567));
            pixels.clone().map(value).collect()
        };
        let id = |seed: u32| Plane::Id(pixels.clone().map(|i| i.wrapping_mul(seed)).collect());
        bands.push(Band {
            first_row,
            rows,
            width,
            color: [plane(1), plane(2), plane(3)],
            alpha: Some(plane(11)),
            layers: vec![
                (Layer::Steps, id(u32::MAX)),
                (Layer::Depth, Plane::Scalar(plane(22))),
                (Layer::Segments, Plane::Scalar(plane(4))),
                (Layer::Redshift, Plane::Scalar(plane(18))),
                (Layer::Position, Plane::Vector([5, 6, 7].map(plane))),
                (Layer::Normal, Plane::Vector([8, 9, 10].map(plane))),
                (Layer::Object, Plane::Scalar(plane(17))),
                (Layer::Status, id(3)),
                (Layer::Samples, id(5)),
                (Layer::StandardError, Plane::Scalar(plane(12))),
                (Layer::Accumulated, Plane::Vector([13, 14, 15].map(plane))),
                (Layer::LuminanceM2, Plane::Scalar(plane(16))),
                (Layer::ImageOrder, Plane::Vector([19, 20, 21].map(plane))),
                (Layer::CrossingRadius, Plane::Crossings([23, 24, 25, 26].map(plane))),
                (Layer::CrossingAzimuth, Plane::Crossings([27, 28, 29, 30].map(plane))),
                (Layer::CrossingTime, Plane::Crossings([31, 32, 33, 34].map(plane))),
                (Layer::CrossingRedshift, Plane::Crossings([35, 36, 37, 38].map(plane))),
                (Layer::CrossingAngle, Plane::Crossings([39, 40, 41, 42].map(plane))),
                (Layer::Magnification, Plane::Scalar(plane(67))),
                (Layer::Bundle, Plane::Vector([68, 69, 70].map(plane))),
            ]
            .into_iter()
            .chain((0..8).map(|k| (Layer::Intensity(k), Plane::Scalar(plane(43 + u32::from(k))))))
            .chain((0..8).map(|k| (Layer::OpticalDepth(k), Plane::Scalar(plane(51 + u32::from(k))))))
            .chain((0..8).map(|k| (Layer::MeanRedshift(k), Plane::Scalar(plane(59 + u32::from(k))))))
            .collect(),
        });
        first_row += rows;
    }
    bands
}

fn write(path: &Path, settings: &FileSettings, bands: &[Band]) {
    let mut writer = open(path, settings).unwrap();
    for band in bands {
        writer.write_band(band).unwrap();
    }
    writer.finish().unwrap();
}

/// Returns the bits of every channel of an EXR, by name.
fn exr_bits(path: &Path) -> BTreeMap<String, Vec<u32>> {
    let image = read_first_flat_layer_from_file(path).unwrap();
    let channels = image.layer_data.channel_data.list;
    channels
        .into_iter()
        .map(|channel| {
            let bits = match channel.sample_data {
                FlatSamples::F32(v) => v.into_iter().map(f32::to_bits).collect(),
                FlatSamples::U32(v) => v,
                FlatSamples::F16(_) => panic!("no half floats are written"),
            };
            (channel.name.to_string(), bits)
        })
        .collect()
}

/// Returns the bits of every channel of some bands, by name.
fn band_bits(bands: &[Band]) -> BTreeMap<String, Vec<u32>> {
    let mut all = BTreeMap::<String, Vec<u32>>::new();
    for band in bands {
        let colors = ["R", "G", "B"].into_iter().zip(&band.color);
        for (name, plane) in colors {
            let bits = plane.iter().map(|v| v.to_bits());
            all.entry(name.into()).or_default().extend(bits);
        }
        for (layer, plane) in &band.layers {
            for (name, bytes) in channels(*layer).iter().zip(components(plane)) {
                let bits = bytes.chunks_exact(4).map(|b| u32::from_ne_bytes(b.try_into().unwrap()));
                all.entry((*name).into()).or_default().extend(bits);
            }
        }
    }
    all
}

#[test]
fn exr_keeps_every_bit_however_the_bands_fall() {
    let folder = folder();
    let path = folder.path().join("a.exr");
    let settings = FileSettings {
        layers: Layer::ALL.to_vec(),
        metadata: vec![("scene".into(), "två hål".into()), ("a".into(), String::new())],
        ..FileSettings::new([13, 61])
    };
    let mut seen: Option<Vec<u8>> = None;
    for heights in [vec![61], vec![1; 61], vec![16, 16, 16, 13], vec![3, 40, 18]] {
        let bands = bands(13, &heights);
        write(&path, &settings, &bands);
        assert_eq!(exr_bits(&path), band_bits(&bands));
        let bytes = fs::read(&path).unwrap();
        assert_eq!(*seen.get_or_insert(bytes.clone()), bytes);
    }
    // The program's reader also finds the written data.
    let all = bands(13, &[61]);
    let (read, band) = picture(&path).unwrap();
    assert_eq!(band.color, all[0].color);
    assert!(
        band.layers.len() == Layer::ALL.len()
            && band.layers.iter().all(|(layer, plane)| all[0].layer(*layer) == Some(plane))
    );
    assert_eq!((read.layers, read.window, read.metadata.len()), (settings.layers.clone(), settings.window, 2));
    let image = read_first_flat_layer_from_file(&path).unwrap();
    let value = &image.layer_data.attributes.other[b"scene".as_slice()];
    let ::exr::meta::attribute::AttributeValue::Text(text) = value else {
        panic!("{value:?}");
    };
    assert_eq!(text.as_slice(), "två hål".as_bytes());
}

#[test]
fn exr_carries_only_the_layers_asked_for() {
    let folder = folder();
    let path = folder.path().join("a.EXR");
    let settings =
        FileSettings { layers: vec![Layer::Steps, Layer::Segments, Layer::Segments], ..FileSettings::new([5, 4]) };
    write(&path, &settings, &bands(5, &[4]));
    let names: Vec<_> = exr_bits(&path).into_keys().collect();
    assert_eq!(names, ["B", "G", "R", "segments", "steps"]);
}

#[test]
fn srgb_has_its_known_values() {
    for (linear, expected) in [
        (0.0, 0.0),
        (0.003_130_8, 0.040_449_936),
        (0.001, 0.012_92),
        (0.214_041_14, 0.5),
        (0.18, 0.461_356),
        (0.5, 0.735_357),
        (1.0, 1.0),
    ] {
        assert!((srgb_from_linear(linear) - expected).abs() < 1e-6, "{linear}");
    }
}

#[test]
fn faults_show_and_large_values_saturate() {
    let magenta = [1.0, 0.0, 1.0];
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1e-3] {
        assert_eq!(display([0.5, bad, 0.5], 1.0, Tonemap::Filmic), magenta);
    }
    for map in [Tonemap::None, Tonemap::Filmic] {
        assert!(display([f32::MAX; 3], 1e90, map).iter().all(|c| (c - 1.0).abs() < 1e-12));
        assert_eq!(display([0.0, -0.0, 0.0], 1e90, map), [0.0; 3]);
        assert!(tonemapped(map, 0.2) < tonemapped(map, 0.21));
    }
    assert!((tonemapped(Tonemap::Filmic, 1.0) - 2.54 / 3.16).abs() < 1e-12);
}

/// Returns one row of grays.
fn grey_row(values: &[f32]) -> Band {
    Band {
        first_row: 0,
        rows: 1,
        width: values.len() as u32,
        color: [(); 3].map(|()| values.to_vec()),
        alpha: None,
        layers: Vec::new(),
    }
}

#[test]
fn png_holds_srgb() {
    let folder = folder();
    let path = folder.path().join("a.png");
    let mut settings = FileSettings {
        metadata: vec![("Software".into(), "bentray".into()), ("Title".into(), "två".into())],
        ..FileSettings::new([5, 1])
    };
    let band = grey_row(&[0.0, 0.25, 0.5, 7.0, f32::NAN]);
    write(&path, &settings, std::slice::from_ref(&band));
    let picture = image::open(&path).unwrap().into_rgb8();
    let pixels: Vec<_> = picture.pixels().map(|p| p.0).collect();
    assert_eq!(pixels, [[0; 3], [137; 3], [188; 3], [255; 3], [255, 0, 255]]);

    settings.bits = 16;
    settings.exposure = 1.0;
    write(&path, &settings, &[band]);
    let picture = image::open(&path).unwrap().into_rgb16();
    assert_eq!(picture.get_pixel(1, 0).0, [48_192; 3]);
    let file = BufReader::new(fs::File::open(&path).unwrap());
    let reader = ::png::Decoder::new(file).read_info().unwrap();
    assert!(reader.info().srgb.is_some());
    let text = &reader.info().uncompressed_latin1_text[0];
    assert_eq!((text.keyword.as_str(), text.text.as_str()), ("Software", "bentray"));
    assert_eq!(reader.info().utf8_text[0].get_text().unwrap(), "två");
}

#[test]
fn png_rows_come_in_order_whatever_the_bands() {
    let folder = folder();
    let [one, many] = ["one.png", "many.png"].map(|name| folder.path().join(name));
    let settings = FileSettings::new([200, 90]);
    write(&one, &settings, &bands(200, &[90]));
    write(&many, &settings, &bands(200, &[1, 30, 7, 52]));
    assert_eq!(fs::read(&one).unwrap(), fs::read(&many).unwrap());
    image::open(&one).unwrap();
}

/// Checks that an image with alpha stores it, and that without alpha the file does not depend on the bands' alpha.
#[test]
fn alpha_is_stored_where_it_is_asked_for() {
    let folder = folder();
    let mut band = grey_row(&[0.0, 0.125, 0.25, 0.5]);
    for name in ["a.png", "a.exr"] {
        let path = folder.path().join(name);
        write(&path, &FileSettings::new([4, 1]), std::slice::from_ref(&band));
        let plain = fs::read(&path).unwrap();
        let settings = FileSettings { alpha: true, ..FileSettings::new([4, 1]) };
        let mut writer = open(&path, &settings).unwrap();
        assert!(writer.write_band(&band).is_err(), "{name} without alpha");
        drop(writer);
        band.alpha = Some(vec![0.0, 0.25, 0.5, 1.0]);
        write(&path, &FileSettings::new([4, 1]), std::slice::from_ref(&band));
        assert!(fs::read(&path).unwrap() == plain, "{name} depends on data that it does not store");
        write(&path, &settings, std::slice::from_ref(&band));
        if name == "a.exr" {
            let bits = exr_bits(&path);
            assert_eq!(bits.keys().collect::<Vec<_>>(), ["A", "B", "G", "R"]);
            // Colors stay premultiplied.
            assert_eq!(bits["R"], [0.0_f32, 0.125, 0.25, 0.5].map(f32::to_bits));
            assert_eq!(bits["A"], [0.0_f32, 0.25, 0.5, 1.0].map(f32::to_bits));
        } else {
            let picture = image::open(&path).unwrap();
            assert_eq!(picture.color(), image::ColorType::Rgba8);
            // The byte 188 is 0.5.
            let pixels: Vec<_> = picture.into_rgba8().pixels().map(|p| p.0).collect();
            assert_eq!(pixels, [[0; 4], [188, 188, 188, 64], [188, 188, 188, 128], [188, 188, 188, 255]]);
        }
        band.alpha = None;
    }
}

#[test]
fn bands_must_come_whole_and_in_order() {
    let folder = folder();
    for name in ["a.png", "a.exr"] {
        let path = folder.path().join(name);
        fs::write(&path, "old").unwrap();
        let good = bands(4, &[2, 2, 1]);
        let mut writer = open(&path, &FileSettings::new([4, 4])).unwrap();
        let mut refused = |band: &Band| {
            let error = writer.write_band(band).unwrap_err();
            assert!(matches!(error, OutputError::Band { .. }), "{error}");
        };
        refused(&good[1]);
        refused(&bands(3, &[2])[0]);
        let mut short = good[0].clone();
        short.color[2].pop();
        refused(&short);
        writer.write_band(&good[0]).unwrap();
        let mut refused = |band: &Band| assert!(writer.write_band(band).is_err());
        refused(&good[0]);
        refused(&bands(4, &[2, 3])[1]);
        let error = writer.finish().unwrap_err();
        assert!(matches!(error, OutputError::Incomplete { rows: 2, .. }), "{error}");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        drop(open(&path, &FileSettings::new([4, 4])).unwrap());
        assert_eq!(fs::read(&path).unwrap(), b"old");
    }
    assert_eq!(names(folder.path()).len(), 2);
}

#[test]
fn exr_layers_must_be_there_and_of_their_kind() {
    let folder = folder();
    let settings = FileSettings { layers: vec![Layer::Segments], ..FileSettings::new([4, 4]) };
    let mut writer = open(&folder.path().join("a.exr"), &settings).unwrap();
    let mut band = bands(4, &[4]).remove(0);
    band.layers.clear();
    assert!(writer.write_band(&band).is_err());
    band.layers = vec![(Layer::Segments, Plane::Id(vec![0; 16]))];
    assert!(writer.write_band(&band).is_err());
    band.layers = vec![(Layer::Segments, Plane::Scalar(vec![0.0; 15]))];
    assert!(writer.write_band(&band).is_err());
    band.layers = vec![(Layer::Segments, Plane::Scalar(vec![0.0; 16]))];
    writer.write_band(&band).unwrap();
    writer.finish().unwrap();
}

/// Checks that the table agrees with the power, including both sides of every threshold of the byte.
#[test]
fn bytes_are_those_of_the_curve() {
    let table = SrgbBytes::table();
    let byte = |x: f64| (srgb_from_linear(x) * 255.0).round() as u8;
    let mut before = 0;
    for k in 0..=200_000 {
        let x = f64::from(k) / 200_000.0;
        assert_eq!(table.of(x), byte(x), "{x}");
        if byte(x) > before {
            let (mut below, mut above) = ((f64::from(k) - 1.0) / 200_000.0, x);
            while below.next_up() < above {
                let middle = 0.5 * (below + above);
                *(if byte(middle) == before { &mut below } else { &mut above }) = middle;
            }
            assert_eq!([table.of(below), table.of(above)], [before, before + 1], "{above}");
            before = byte(x);
        }
    }
}

#[test]
fn files_say_what_they_were_written_with() {
    let folder = folder();
    let metadata = vec![("a".to_owned(), "två".to_owned()), ("b".to_owned(), "x = 1\ny = 2".to_owned())];
    let window = Window { origin: [3, 5], size: [8, 6] };
    for (name, layers, alpha, bits) in [
        ("a.exr", vec![], true, 8),
        ("b.exr", vec![Layer::Segments, Layer::Normal], false, 16),
        ("c.png", vec![], true, 8),
        ("d.png", vec![], false, 16),
    ] {
        let (exposure, tonemap) = (-1.25, Tonemap::Filmic);
        let metadata = metadata.clone();
        let settings =
            FileSettings { window, exposure, tonemap, bits, alpha, layers, metadata, ..FileSettings::new([16, 12]) };
        let path = folder.path().join(name);
        let mut writer = open(&path, &settings).unwrap();
        writer.write_band(&plain(window.size, &settings)).unwrap();
        writer.finish().unwrap();
        assert_eq!(settings_of(&path).unwrap(), settings, "{name}");
    }
}

fn plain([width, rows]: [u32; 2], settings: &FileSettings) -> Band {
    let plane = || vec![0.5; (width * rows) as usize];
    let layer = |layer: &Layer| match layer {
        Layer::Normal => (*layer, Plane::Vector([plane(), plane(), plane()])),
        _ => (*layer, Plane::Scalar(plane())),
    };
    let layers = settings.layers.iter().map(layer).collect();
    Band { first_row: 0, rows, width, color: [plane(), plane(), plane()], alpha: settings.alpha.then(plane), layers }
}
