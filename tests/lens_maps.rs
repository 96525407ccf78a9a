//! Tests that images from lens maps have the bits of new renders, with other colors, skies, tiles and windows.

use std::sync::Arc;

use bentray::program::{Layer, PathEnds, ProgramOptions, Schedule};
use bentray::render::{Band, LensMap, RenderSettings, Renderer, Window};
use bentray::scene::{Image, Scene};

use crate::support::{gpu, scene};

const LAYERS: [Layer; 4] = [Layer::Position, Layer::Normal, Layer::Object, Layer::Status];

fn settings(ends: PathEnds, schedule: Schedule) -> RenderSettings {
    let options = ProgramOptions { ends, schedule, layers: LAYERS.to_vec(), ..ProgramOptions::default() };
    RenderSettings { options, ..RenderSettings::default() }
}

fn mapped(scene: &Scene, schedule: Schedule, tile_pixels: u64) -> LensMap {
    let gpu = gpu();
    let settings = RenderSettings { tile_pixels, ..settings(PathEnds::Stored, schedule) };
    let (map, layers, totals) = Renderer::new(&gpu, scene, settings).unwrap().map().unwrap();
    assert_eq!((layers.width, layers.rows), scene.image.size.into());
    assert!(totals.rays > 0);
    map
}

fn rendered(scene: &Scene) -> Band {
    let gpu = gpu();
    Renderer::new(&gpu, scene, settings(PathEnds::Followed, Schedule::Whole)).unwrap().render().unwrap().band
}

fn shaded(scene: &Scene, map: &Arc<LensMap>, tile_pixels: u64, window: Option<Window>) -> Band {
    let gpu = gpu();
    let settings = RenderSettings { tile_pixels, window, ..settings(PathEnds::Followed, Schedule::Whole) };
    Renderer::of_map(&gpu, scene.clone(), settings, map.clone()).unwrap().render().unwrap().band
}

/// Scenes with everything that the end of a path stores, and two looks of each.
fn scenes() -> Vec<(&'static str, [Scene; 2])> {
    let of = |rest: &str, looks: [&str; 2]| {
        looks.map(|look| {
            scene(&format!(
                "[image]\nsize = [40, 24]\nsamples = 3\n[rays]\nmethod = \"rk4\"\nbounding_sphere = {{ radius = 40 }}\n{rest}\n{look}\n"
            ))
        })
    };
    let stars = "[sky]\nimage = \"data/stars.png\"";
    let grid = "[output]\nexposure = 2\n[sky]\nimage = \"data/graticule.png\"";
    let hole = "[camera]\nposition = [0, 2, 18]\n[law]\nkind = \"schwarzschild\"";
    let disk = "[camera]\nposition = [18, 3, 4]\nobserver = \"static\"\nredshift = true\n[law]\nkind = \"kerr-newman\"\nspin = 0.9\n\
                axis = [0, 1, 0]\n[[objects]]\nshape = \"disk\"\nmaterial = \"m\"\nradius = 20\ninner_radius = 3\n[materials.m]\n\
                kind = \"accretion\"\nopacity = 0.4";
    let glass = "[camera]\nposition = [0, 2, 16]\n[law]\nkind = \"schwarzschild\"\nmass = 0.3\n[materials.glass]\nkind = \"mirror\"\n\
                 color = [0.9, 0.5, 0.3]\n[[objects]]\nshape = \"sphere\"\ninterior = 1.5\ncenter = [3, 0, 2]\nradius = 2\n[[objects]]\n\
                 shape = \"sphere\"\nmaterial = \"glass\"\ncenter = [-3, 0, 2]\nradius = 2\n[[objects]]\nshape = \"box\"\nmaterial = \"m\"\n\
                 center = [0, -4, 0]\nsize = [20, 1, 20]";
    let floor = "[materials.m]\nkind = \"phong\"\ndiffuse = [1, 1, 1]\n[[lights]]\nkind = \"point\"\nposition = [0, 8, 8]\n\
                 color = [300, 300, 300]";
    let other_floor =
        floor.replace("[1, 1, 1]", "{ checker = [[1, 0, 0], [0, 0, 1]], repeat = [6, 6] }").replace("8, 8]", "6, 9]");
    let throat = "[camera]\nposition = [0, 0.5, 4.5]\n[law]\nkind = \"wormhole\"\nradius = 1\nother_mouth = [90, 0, 0]";
    let twin = |sky: &str, other: &str| {
        format!("[sky]\nimage = \"data/{sky}.png\"\n[sky.other_side]\nimage = \"data/{other}.png\"")
    };
    let wave = "[camera]\nposition = [0, 0, 12]\nobserver = \"static\"\nredshift = true\n[law]\nkind = \"metric\"\n\
                scale = \"1\"\nline_element = \"-dt^2 + (1 + 0.1*sin(t - z))*dx^2 + (1 - 0.1*sin(t - z))*dy^2 + dz^2\"";
    vec![
        ("sky", of(hole, [stars, grid])),
        ("disk", of(&format!("{disk}\ntemperature = 7000"), [stars, grid])),
        ("glass", of(glass, [&format!("{floor}\n{stars}"), &format!("{other_floor}\n{grid}")])),
        ("wormhole", of(throat, [&twin("stars", "graticule"), &twin("graticule", "stars")])),
        ("wave", of(wave, [stars, grid])),
        ("footprints", of(hole, [stars, grid]).map(filtered)),
        ("filtered disk", of(&format!("{disk}\ntemperature = 7000"), [stars, grid]).map(filtered)),
    ]
}

fn filtered(scene: Scene) -> Scene {
    Scene { image: Image { footprints: true, ..scene.image.clone() }, ..scene }
}

#[test]
fn images_from_maps_have_the_bits_of_new_ones() {
    for (name, [traced, other]) in scenes() {
        let map = Arc::new(mapped(&traced, Schedule::Whole, u64::MAX));
        assert!(["sky", "wave", "footprints"].contains(&name) || map.rounds.len() >= 3, "{name}: {}", map.rounds.len());
        for scene in [&traced, &other] {
            let expected = rendered(scene);
            assert!(shaded(scene, &map, u64::MAX, None) == expected, "{name}");
            assert!(shaded(scene, &map, 300, None) == expected, "{name} in tiles");
        }
    }
}

#[test]
fn maps_do_not_depend_on_schedules_and_tiles() {
    for (name, [scene, _]) in scenes() {
        let map = mapped(&scene, Schedule::Whole, u64::MAX);
        for (schedule, tile_pixels) in [(Schedule::Segment, u64::MAX), (Schedule::Fused, 300)] {
            assert!(mapped(&scene, schedule, tile_pixels) == map, "{name}: {schedule:?}, {tile_pixels}");
        }
    }
}

#[test]
fn windows_show_their_part_of_a_map() {
    let [(_, [scene, _]), ..] = &scenes()[..] else { panic!() };
    let map = Arc::new(mapped(scene, Schedule::Whole, u64::MAX));
    let window = Window { origin: [7, 5], size: [20, 11] };
    let (whole, part) = (rendered(scene), shaded(scene, &map, 128, Some(window)));
    for y in 0..11 {
        let rows = |band: &Band, at: usize| band.color.each_ref().map(|plane| plane[at..at + 20].to_vec());
        assert!(rows(&part, y * 20) == rows(&whole, (5 + y) * 40 + 7), "row {y}");
    }
}
