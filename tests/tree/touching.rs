//! Tests objects that touch: one surface between two media, and none between glass and the object below it.

use super::device::{ROOM, agreement, room};
use super::{difference, with_objects};
use crate::exactness::unused;
use crate::support::{assert_same_image, gpu, scene};
use bentray::gpu::Geometry;
use bentray::program::{Layer, Mode, Program, ProgramOptions, RaySkipping, Schedule};
use bentray::render::{RenderSettings, Renderer};
use glam::DVec3;

const LEFT: &str = "shape = \"box\"\nmin = [-1.1, -1.2, -0.4]\nmax = [0.3, 0.5, 0.9]\ninterior = 1.5";
const RIGHT: &str = "shape = \"box\"\nmin = [0.3, -1, -0.6]\nmax = [1.6, 0.7, 0.7]\ninterior = INDEX";
const BLOCK: &str = "shape = \"box\"\nmin = [-0.8, -1.5, -0.4]\nmax = [0.9, 0.1, 0.9]\ninterior = 1.5";
const TURNED: &str = "rotate = [20, 30, 10]\ntranslate = [0.2, 0.1, 0.3]";

/// Returns every scene with objects that touch: its name, its splits and its objects.
fn scenes() -> Vec<(&'static str, u32, Vec<String>)> {
    let of = |objects: &[&str]| objects.iter().map(|object| (*object).to_owned()).collect::<Vec<_>>();
    let turned = |objects: &[&str]| objects.iter().map(|object| format!("{object}\n{TURNED}")).collect::<Vec<_>>();
    let [right, same] = ["1.33", "1.5"].map(|index| RIGHT.replace("INDEX", index));
    let glass = "shape = \"box\"\nmin = [-1, -1.2, -0.6]\nmax = [1, 0.6, 1]\ninterior = 1.5";
    let water = "shape = \"box\"\nmin = [-0.7, -0.9, -0.3]\nmax = [1, 0.3, 0.8]\ninterior = \"water\"";
    let table = "shape = \"box\"\nmin = [-1.5, -1.8, -1]\nmax = [1.6, -0.9, 1.5]\nmaterial = \"shiny\"";
    let on_it = "shape = \"box\"\nmin = [-0.8, -0.9, -0.4]\nmax = [0.9, 0.5, 0.9]\ninterior = 1.5";
    let disk = "shape = \"disk\"\ncenter = [0.1, -0.9, 0.2]\nradius = 1.4\ninner_radius = 0.4\nmaterial = \"floor\"";
    let mirror_box = table.replace("shiny", "mirror");
    let mirror_disk = disk.replace("floor", "mirror");
    let ball = "shape = \"sphere\"\ncenter = [0.2, -0.3, 0.5]\nradius = 1.1\ninterior = 1.5";
    let filling = "shape = \"sphere\"\ncenter = [0.2, -0.3, 0.5]\nradius = 1.1\ninterior = 1.8\npriority = 1";
    let pillar = "shape = \"cylinder\"\ncenter = [0.1, -0.2, 0.2]\nradius = 0.7\nheight = 1.4\ninterior = 1.8";
    let tube = "shape = \"cylinder\"\ncenter = [0.1, -0.2, 0.2]\nradius = 0.9\nheight = 1.4\ninterior = 1.5";
    let core = "shape = \"cylinder\"\ncenter = [0.1, -0.2, 0.2]\nradius = 0.6\nheight = 1.4\ninterior = \"water\"";
    vec![
        ("two glasses", 3, of(&[LEFT, &right])),
        ("two glasses, turned", 3, turned(&[LEFT, &right])),
        ("two of one glass", 3, of(&[LEFT, &same])),
        ("water in glass", 3, of(&[glass, water])),
        ("water in glass, turned", 3, turned(&[glass, water])),
        ("block on the floor", 3, of(&[BLOCK])),
        ("block on a table", 3, of(&[table, on_it])),
        ("block on a table, turned", 3, turned(&[table, on_it])),
        ("block on a disk", 3, of(&[disk, on_it])),
        ("block on a mirror box", 3, of(&[&mirror_box, on_it])),
        ("block on a mirror disk", 3, of(&[&mirror_disk, on_it])),
        ("ball filled", 3, of(&[ball, filling])),
        ("pillar on a table", 3, of(&[table, pillar])),
        ("pillar on glass", 3, of(&[&table.replace("material = \"shiny\"", "interior = 1.5"), pillar])),
        ("core in a tube", 3, of(&[tube, core])),
    ]
}

fn text(branches: u32, objects: &[String]) -> String {
    room(branches, &objects.iter().map(String::as_str).collect::<Vec<_>>())
}

#[test]
fn touching_objects_are_rendered_as_they_are_traced() {
    let parts: Vec<_> =
        scenes().iter().map(|(name, branches, objects)| (*name, agreement(&text(*branches, objects), 1e-5))).collect();
    for (name, part) in &parts {
        println!("{name}: {:.3} % agree", 100.0 * part);
    }
    assert!(parts.iter().all(|(_, part)| *part >= 0.999), "fractions of the pixels that agree: {parts:#?}");
}

/// Cylinders and disks that touch nothing, which the tracer also supports.
#[test]
fn cylinders_and_disks_are_rendered_as_they_are_traced() {
    let rod = "shape = \"cylinder\"\ncenter = [0.2, -0.3, 0.5]\nradius = 0.8\nheight = 1.6\nrotate = [30, 10, 20]\ninterior = 1.5";
    let ring = "shape = \"disk\"\ncenter = [-1.2, 0, 0]\nnormal = [1, 0.3, 0.5]\nradius = 1.2\ninner_radius = 0.5\nmaterial = \"floor\"";
    let post = "shape = \"cylinder\"\ncenter = [1.6, -0.8, 1.2]\nradius = 0.3\nheight = 1\nmaterial = \"floor\"";
    for (name, objects) in [("rod", [rod, post]), ("ring", [ring, rod])] {
        let part = agreement(&room(3, &objects), 1e-5);
        println!("{name}: {:.3} % agree", 100.0 * part);
        assert!(part >= 0.999, "{name}: {part}");
    }
}

fn rendered(text: &str, options: ProgramOptions) -> bentray::render::Rendering {
    Renderer::new(&gpu(), &scene(text), RenderSettings { options, ..RenderSettings::default() })
        .unwrap()
        .render()
        .unwrap()
}

/// Two boxes of one glass are one box, in 64 bits too.
#[test]
fn halves_are_a_whole() {
    let halves = ["[-1, -1, -1]\nmax = [0.2, 1, 1]", "[0.2, -1, -1]\nmax = [1, 1, 1]"];
    let cuboid = |corners: &str| format!("shape = \"box\"\nmin = {corners}\ninterior = 1.5\n{TURNED}");
    let [a, b] = halves.map(cuboid);
    let whole = cuboid("[-1, -1, -1]\nmax = [1, 1, 1]");
    for precision in ["f32", "f64"] {
        let color = |objects: &[&str]| {
            let text = with_objects(&ROOM.replace("BRANCHES", &format!("3\nprecision = \"{precision}\"")), objects);
            let color = rendered(&text, ProgramOptions::default()).band.color;
            let at = |i: usize| DVec3::from([0, 1, 2].map(|channel: usize| f64::from(color[channel][i])));
            (0..color[0].len()).map(at).collect::<Vec<_>>()
        };
        let (parts, one) = (color(&[&a, &b]), color(&[&whole]));
        let alike = parts.iter().zip(&one).filter(|(a, b)| difference(&[**a], &[**b]) < 1e-5).count();
        println!("{precision}: {alike} of {}", one.len());
        assert!(alike as f64 >= 0.999 * one.len() as f64, "{precision}: {alike} of {}", one.len());
    }
}

#[test]
fn touching_objects_do_not_depend_on_the_schedule() {
    for (name, branches, objects) in scenes() {
        if !["water in glass", "block on a table", "block on a mirror disk"].contains(&name) {
            continue;
        }
        for segments in [60, 3] {
            let text = text(branches, &objects)
                .replace("[128, 96]", "[40, 30]")
                .replace("[rays]", &format!("[rays]\nmax_segments = {segments}"));
            let options = |schedule, masks| ProgramOptions {
                schedule,
                masks,
                layers: Layer::ALL.to_vec(),
                ..ProgramOptions::default()
            };
            let first = rendered(&text, options(Schedule::Fused, RaySkipping::List));
            for (schedule, masks) in [
                (Schedule::Whole, RaySkipping::List),
                (Schedule::Fused, RaySkipping::Off),
                (Schedule::Segment, RaySkipping::List),
                (Schedule::Paper, RaySkipping::Grid),
            ] {
                let other = rendered(&text, options(schedule, masks));
                assert_same_image(
                    &other,
                    &first,
                    &format_args!("{name}: {schedule:?}, masks {masks:?}, {segments} segments"),
                );
                assert_eq!(first.totals.by_status, other.totals.by_status, "{name}");
            }
        }
    }
}

/// Only scenes with touching objects search for them, not those with nested or separate objects or contact at a point; and
/// nothing can be removed from their programs.
#[test]
fn what_does_not_touch_pays_nothing() {
    let links = |text: &str| {
        let scene = scene(text);
        let geometry = Geometry::new(&scene);
        let mut found = Vec::new();
        for (schedule, mode) in [(Schedule::Fused, Mode::Picture), (Schedule::Segment, Mode::Trace)] {
            let options = ProgramOptions { schedule, mode, ..ProgramOptions::default() };
            let program = Program::new(&scene, &geometry.analysis, &options, geometry.extent()).unwrap();
            for (pass, linked, _) in &program.passes {
                let unused = unused(linked).unwrap_or_else(|error| panic!("{error}"));
                assert!(unused.is_empty(), "pass {} has {unused:?}", pass.entry());
            }
            found.push(program.passes.iter().any(|(_, linked, _)| linked.source.contains("fn alignment(")));
        }
        assert_eq!(found[0], found[1]);
        found[0]
    };
    for (name, branches, objects) in scenes() {
        assert!(links(&text(branches, &objects)), "{name}");
    }
    let ball = "shape = \"sphere\"\nradius = 1.5\ninterior = 1.5";
    for apart in [
        &[ball][..],
        &[ball, "shape = \"sphere\"\nradius = 1.2\ninterior = 1"],
        &[ball, "shape = \"box\"\ncenter = [0, 2.5, 0]\nsize = [2, 2, 2]\ninterior = \"water\""],
        &["shape = \"box\"\nmin = [-1, -1.49, -1]\nmax = [1, 1, 1]\ninterior = 1.5"],
        &[LEFT, &RIGHT.replace("INDEX", "1.33").replace("min = [0.3", "min = [0.3001")],
    ] {
        assert!(!links(&room(3, apart)), "{apart:?}");
    }
}
