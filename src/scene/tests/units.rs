//! Tests of `[units]` and of numbers with units.

use std::collections::BTreeSet;
use std::path::Path;

use super::scenes::KINDS;
use super::{RAYS, good, marked};
use crate::assets::Files;
use crate::document::reader::Reader;
use crate::document::{Dimension, Document, Node, Quantity, Table, Value};
use crate::model::camera::{Pinhole, Plane};
use crate::model::law::RoundHole;
use crate::scene::check::scene;
use crate::scene::{Accuracy, REFERENCE, Scene};

/// A solar mass at one parsec: a scene unit is 1476.625 m, and an astronomical unit subtends a second of arc.
const UNITS: &str = "[units]\nmass = \"1 Msun\"\ndistance = \"1 pc\"\n";
/// The unit of length of [`UNITS`], in meters: GM/c² of the Sun, by the nominal values of the IAU.
const LENGTH: f64 = 1.327_124_4e20 / (299_792_458.0 * 299_792_458.0);

/// Keys with values in scene units that `KINDS` does not set.
const LENGTHS: &str = "[camera]\nposition = [0, 0, 9]\nlook_at = [0, 1, 0]\n[rays]\narc_tolerance = 0.1\n\
     bounding_sphere = { radius = 99 }\n[ambient]\ndistance = 3\n[materials.m]\n[[objects]]\nshape = \"sphere\"\n\
     material = \"m\"\ncenter = [1, 2, 3]\nradius = 2\ntranslate = [1, 2, 3]\n[[objects]]\nshape = \"disk\"\n\
     material = \"m\"\nradius = 2\ninner_radius = 1\n[[objects]]\nshape = \"cylinder\"\nmaterial = \"m\"\nheight = 2\n\
     [[objects]]\nshape = \"box\"\nmaterial = \"m\"\nsize = [1, 2, 3]\n[[objects]]\nshape = \"plane\"\nmaterial = \"m\"\n\
     size = [4, 5]\nscale = 2\nrotate = [10, 20, 30]\n[[objects]]\nshape = \"sphere\"\ncenter = [0, 0, -50]\n\
     interior = { kind = \"expression\", n = \"1 + x^2\", center = [0, 0, 0], scale = 2 }\n[[lights]]\nkind = \"point\"\n\
     position = [0, 0, 1]\nshadows = \"curved-rays\"\nmin_distance = 0.1\n";

fn near(value: f64, expected: f64) {
    assert!((value / expected - 1.0).abs() < 1e-12, "{value} is not {expected}");
}

fn camera(text: &str) -> Scene {
    good(&format!("{UNITS}{RAYS}[image]\nsize = [80, 20]\n[camera]\n{text}"))
}

#[test]
fn units_become_scene_units() {
    let scene = good(&format!(
        "{UNITS}[law]\nkind = \"schwarzschild\"\nmass = \"2 Msun\"\ncenter = [\"1 km\", 0, \"-2km\"]\n\
         [rays]\nbounding_sphere = {{ radius = \"1 Rsun\" }}\naccuracy = \"0.1 deg\"\nmethod = \"auto\"\n"
    ));
    near(scene.rays.bounding_sphere.radius, 6.957e8 / LENGTH);
    assert_eq!(scene.rays.auto.map(|auto| auto.accuracy), Some(Accuracy::Radians(0.1_f64.to_radians())));
    let hole: &RoundHole = scene.law.downcast().expect("a hole");
    near(hole.mass, 2.0);
    near(hole.center.x, 1e3 / LENGTH);
    near(hole.center.z, -2e3 / LENGTH);
    let scene = camera("position = [0, 0, \"1000 km\"]\ntime = \"2 ms\"\nfov = \"30 deg\"");
    let camera = scene.camera.expect("a camera");
    near(camera.position.z, 1e6 / LENGTH);
    near(camera.time, 2e-3 * 299_792_458.0 / LENGTH);
    assert_eq!(camera.projection.downcast(), Some(&Pinhole { fov: 30.0 }));
    let long = good(&format!("[units]\nlength = \"1 km\"\n{RAYS}[camera]\nposition = [0, \"1 au\", 2]\n"));
    near(long.camera.expect("a camera").position.y, 149_597_870.7);
}

/// Checks that images cover the angle on the sky that their scene gives, for two projections.
#[test]
fn angles_on_the_sky_are_lengths_at_the_distance() {
    let unit = LENGTH / (149_597_870_700.0 * 648_000.0 / std::f64::consts::PI);
    let height = 1e-6 * std::f64::consts::PI / 648_000.0 * 40.0 / unit;
    let flat = camera("kind = \"orthographic\"\nposition = [0, 0, 99]\nheight = \"40 uas\"");
    let sees: &Plane = flat.camera.as_ref().and_then(|camera| camera.projection.downcast()).expect("a plane");
    near(sees.height, height);
    let round = camera("position = [0, 3, 99]\nlook_at = [0, 3, 0]\nfov = \"40 uas\"");
    let sees: &Pinhole = round.camera.as_ref().and_then(|camera| camera.projection.downcast()).expect("a pinhole");
    near(2.0 * 99.0 * (0.5 * sees.fov).to_radians().tan(), height);
    for scene in [flat, round] {
        near(scene.pixel_on_sky().expect("an angle"), height * unit / 20.0);
    }
    assert_eq!(camera("kind = \"fisheye\"\nposition = [0, 0, 9]").pixel_on_sky(), None);
}

/// Sets a number with a unit at every number, one by one, and compares the keys that accept it with the reference.
#[test]
fn the_keys_in_scene_units_accept_lengths() {
    let (mut tried, mut wrong) = (0, BTreeSet::new());
    for text in KINDS.iter().chain([&LENGTHS]) {
        let parsed = || Document::parse(text, Path::new("no folder/scene.toml"), &[]).expect("TOML");
        let refuses = |document: &Document| {
            let reader = Reader::new(document, &REFERENCE);
            scene(&reader, &mut Files::default());
            reader.into_mistakes().iter().any(|mistake| mistake.problem.contains("found a length (replaced)"))
        };
        for i in 0.. {
            let (mut document, mut left) = (parsed(), i);
            let Some(key) = replace_number(&mut document.root, &mut left) else { break };
            let is_length = |row: &&crate::scene::KeyReference| row.meaning.contains("scene units");
            let rows: Vec<_> = REFERENCE.iter().filter(|row| row.key == key).collect();
            let (some, all) = (rows.iter().any(is_length), rows.iter().all(is_length));
            let accepted = !refuses(&document);
            // A track has the units of the key that it animates.
            if key != "values" && accepted != some && (accepted || all && !PLAIN.contains(&&*key)) {
                wrong.insert((key, if accepted { "accepts a length" } else { "refuses a length" }));
            }
            tried += usize::from(accepted);
        }
    }
    assert!(tried > 60 && wrong.is_empty(), "{tried}: {wrong:?}");
}

/// Keys whose meaning contains scene units in a product or as an alternative.
const PLAIN: [&str; 5] = ["cubic", "scaled_step", "cosmological_constant", "velocity", "points"];

/// Replaces the number at the index `left` of a table by a length of the same value, and returns its key.
fn replace_number(table: &mut Table, left: &mut usize) -> Option<String> {
    table.iter_mut().find_map(|(key, _, node)| replace(node, key, left))
}

fn replace(node: &mut Node, key: &str, left: &mut usize) -> Option<String> {
    let number = match &mut node.value {
        Value::Integer(number) => *number as f64,
        Value::Float(number) => *number,
        Value::Array(items) => return items.iter_mut().find_map(|item| replace(item, key, left)),
        Value::Table(table) => return replace_number(table, left),
        _ => return None,
    };
    if *left > 0 {
        *left -= 1;
        return None;
    }
    let read = Quantity { text: "replaced".into(), dimension: Dimension::Length, si: number, value: Some(number) };
    node.value = Value::Quantity(read);
    Some(key.to_owned())
}

#[test]
fn wrong_units_name_the_right_ones() {
    let told = |text: &str| {
        let mistake = marked(text);
        (mistake.problem, mistake.help)
    };
    let with = |text: &str| told(&format!("{UNITS}{text}"));
    let (problem, help) = with("[rays]\nbounding_sphere = { radius = «\"2 h\"» }\n");
    assert_eq!(problem, "expected a length, found a time (2 h)");
    assert!(help.starts_with("use a number, or a length with one of the units nm, um, µm, mm, cm, m, km"), "{help}");
    let (problem, _) = with("[image]\nsamples = «\"2 m\"»\n[rays]\nbounding_sphere = { radius = 1 }\n");
    assert!(problem.ends_with("found a length (2 m)"), "{problem}");
    let (problem, help) = told("[rays]\nbounding_sphere = { radius = «\"2 km\"» }\n");
    assert_eq!(problem, "expected a number, found the string \"2 km\", and units require the table [units]");
    assert!(help.starts_with("`radius`: "), "{help}");
    let (problem, help) = told("[units]\n[rays]\nbounding_sphere = { radius = «\"2 uas\"» }\n");
    assert_eq!(problem, "2 uas has no value in the units of this scene");
    assert_eq!(help, "add units.distance, and units.mass or units.length");
    let (problem, help) = told(&format!("[units]\nmass = «\"2 km\"»\n{RAYS}"));
    assert_eq!(problem, "expected a mass with its unit, found the string \"2 km\"");
    assert_eq!(help, "write a string with one of the units g, kg, Mearth, Mjup, Msun");
    let (problem, _) = told(&format!("[units]\nmass = \"1 kg\"\nlength = «\"2 km\"»\n{RAYS}"));
    assert_eq!(problem, "`length` cannot be combined with `mass`");
    let (problem, _) = told(&format!("[units]\ndistance = «\"2 km\"»\n{RAYS}"));
    assert_eq!(problem, "`distance` requires the unit of length of the scene");
    let (problem, _) = told(&format!("[units]\nlength = «\"-2 km\"»\n{RAYS}"));
    assert!(problem.starts_with("expected a value above 0, found -2000"), "{problem}");
    let (problem, help) = with(&format!("{RAYS}[camera]\nposition = [0, 0, 9]\nfov = «\"2 km\"»\n"));
    assert_eq!(problem, "expected an angle, found a length (2 km)");
    assert_eq!(help, "use a number, or an angle with one of the units deg, mrad, rad");
}

/// Checks that tracks interpolate numbers with units, and refuse to mix units of several kinds.
#[test]
fn tracks_have_units() {
    let text = |values: &str| {
        format!(
            "{UNITS}{RAYS}[camera]\nposition = [0, 0, 9]\nfov = 20\n[animation]\nframes = 3\n\
             [[animation.tracks]]\nkey = \"camera.fov\"\nvalues = [{values}]\n"
        )
    };
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text("\"10 deg\", \"50 deg\"")).expect("a file");
    let at = |frame: f64| Scene::load_with(&mut Files::default(), &path, &[], Some(&|_: &str| frame)).expect("a scene");
    let fov = |scene: Scene| scene.camera.and_then(|camera| camera.projection.downcast().map(|p: &Pinhole| p.fov));
    assert!((fov(at(1.0)).expect("a field of view") - 30.0).abs() < 1e-12);
    let mistake = marked(&text("\"10 deg\", «20»"));
    assert!(mistake.problem.ends_with("different shapes or kinds of units"), "{mistake}");
}
