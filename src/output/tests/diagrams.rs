//! Tests of ray diagrams: they show the surfaces in their plane, and nothing outside their frame.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::plots::{png, svg};
use crate::measure::{Curve, Focus};
use crate::model::shape::Sphere;
use crate::output::plot::{CrossSection, PathLine, PathPlot, PlotRange, SurfaceKind, plot_paths};
use crate::scene::{CutPlane, Object, Substance, Transform};

/// Returns straight lines past a center, bent towards it, in the plane of x and z.
pub(super) fn lines() -> Vec<PathLine<'static>> {
    let status = ["escaped", "captured", "hit", "step limit"];
    (0..12)
        .map(|i| {
            let impact = -6.0 + f64::from(i);
            let path = |t: f64| [t, 0.001 * t, impact - impact * (t + 10.0).powi(2) / 300.0];
            let points: Vec<_> = (0..200).map(|k| path(-10.0 + f64::from(k) * 0.09).into()).collect();
            PathLine { curve: Curve::through(&points), status: status[i as usize % 4] }
        })
        .collect()
}

/// Returns the plane of x and z.
fn plane() -> CutPlane {
    CutPlane::new(DVec3::ZERO, DVec3::Y).unwrap()
}

/// Returns a diagram of all of these paths.
pub(super) fn all(lines: Vec<PathLine<'static>>) -> PathPlot<'static> {
    PathPlot { bound: Some((DVec3::ZERO, 12.0)), ..PathPlot::new(plane(), lines) }
}

/// Returns the cross section of a ball.
fn ball(center: DVec3, radius: f64, kind: SurfaceKind) -> CrossSection {
    let transform = Transform::new(DVec3::splat(radius), DVec3::ZERO, center);
    let object = Object::new(Arc::new(Sphere), transform, Substance::Opaque(0));
    CrossSection { kind, outlines: object.cut(&plane()) }
}

/// Returns the numbers in a text, in order.
fn numbers(text: &str) -> Vec<f64> {
    let words = text.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'));
    words.filter_map(|word| word.parse().ok()).collect()
}

/// Returns the numbers of a path element's data, as points.
pub(super) fn points(line: &str) -> Vec<[f64; 2]> {
    let data = line.split(" d=\"").nth(1).unwrap().split('"').next().unwrap();
    numbers(data).chunks_exact(2).map(|p| [p[0], p[1]]).collect()
}

/// Returns the `<path>` elements in the window of an SVG: the line of text, and the points of its data.
fn paths(svg: &str) -> Vec<(&str, Vec<[f64; 2]>)> {
    let inside = svg.split("<g clip-path").nth(1).unwrap().split("</g>").next().unwrap();
    inside.lines().filter(|line| line.starts_with("<path")).map(|line| (line, points(line))).collect()
}

/// Returns the window of data: left, top, right and bottom.
fn window(svg: &str) -> [f64; 4] {
    let corners = points(svg.split("<clipPath").nth(1).unwrap());
    [corners[0][0], corners[0][1], corners[2][0], corners[2][1]]
}

#[test]
fn paths_are_named_by_their_ends() {
    let svg = svg("paths.svg", |path| plot_paths(path, &all(lines())).unwrap());
    for text in ["x (scene units)", "z (scene units)", "escaped", "step limit", "bound"] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(!svg.contains("y (scene units)"));
    // The bounding circle, and a line and an arrow for each path.
    assert_eq!(paths(&svg).len(), 1 + 2 * 12);
    assert!(!svg.contains("rays leave the plane"));
}

#[test]
fn paths_that_leave_the_plane_are_said_to() {
    let mut lines = lines();
    lines[3].curve = Curve::through(&[DVec3::ZERO, DVec3::new(5.0, 0.5, 0.0)]);
    let svg = svg("leaving.svg", |path| plot_paths(path, &all(lines)).unwrap());
    assert!(svg.contains("rays leave the plane"));
}

#[test]
fn no_paths_are_drawn_too() {
    let svg = svg("none.svg", |path| plot_paths(path, &PathPlot::new(plane(), Vec::new())).unwrap());
    assert!(svg.contains("x (scene units)") && svg.contains("z (scene units)"));
}

#[test]
fn nothing_is_outside_of_the_frame() {
    let surfaces = vec![
        ball(DVec3::new(2.0, 0.0, 3.0), 4.0, SurfaceKind::Medium),
        ball(DVec3::new(-9.0, 0.0, 0.0), 6.0, SurfaceKind::Opaque),
    ];
    let plot = PathPlot { range: PlotRange::Given([-3.0, 4.0, -2.0, 3.0]), surfaces, ..all(lines()) };
    let svg = svg("frame.svg", |path| plot_paths(path, &plot).unwrap());
    let [left, top, right, bottom] = window(&svg);
    let mut count = 0;
    for (line, points) in paths(&svg).into_iter().filter(|(line, _)| line.contains("fill=\"none\"")) {
        count += 1;
        for [x, y] in points {
            let within = x >= left - 0.01 && x <= right + 0.01 && y >= top - 0.01 && y <= bottom + 0.01;
            assert!(within, "[{x}, {y}] is not in {:?}: {line}", window(&svg));
        }
    }
    assert!(count > 10);
    // The bounding circle is outside.
    assert!(!svg.contains("bound"));
    // Areas are clipped: everything is white between the window and the legend, and above it.
    let picture = png("frame.png", |path| plot_paths(path, &plot).unwrap());
    let white = |x: u32, y: u32| picture.get_pixel(x, y).0 == [255; 3];
    assert!((0..1080).all(|y| (1..29).all(|x| white(right as u32 + x, y))));
    assert!((170..right as u32).all(|x| (0..29).all(|y| white(x, y))));
    assert!(!white(right as u32 - 2, 35), "the medium fills the upper right corner");
}

#[test]
fn a_ball_is_a_circle_of_its_size() {
    let radius = 2.5;
    // Off-center by 1.5: √(2.5² − 1.5²) = 2.
    let surfaces = vec![ball(DVec3::new(1.0, 1.5, -1.0), radius, SurfaceKind::Medium)];
    let plot = PathPlot { range: PlotRange::Objects, surfaces, ..all(lines()) };
    let svg = svg("ball.svg", |path| plot_paths(path, &plot).unwrap());
    assert!(svg.contains("medium"));
    let paths = paths(&svg);
    let filled: Vec<_> = paths.iter().filter(|(line, _)| line.contains("fill-opacity=\"0.2\"")).collect();
    let [(_, points)] = filled[..] else { panic!("{} filled", filled.len()) };
    let [left, top, right, bottom] = window(&svg);
    let middle = points.iter().fold([0.0; 2], |sum, p| [sum[0] + p[0], sum[1] + p[1]]).map(|v| v / points.len() as f64);
    let distances: Vec<f64> = points.iter().map(|p| (p[0] - middle[0]).hypot(p[1] - middle[1])).collect();
    // The frame around an object is half as large again, so that its height is 3 radii.
    let expected = (bottom - top) / 3.0;
    assert!(distances.iter().all(|d| (d - expected).abs() < 1.0), "{expected}: {distances:?}");
    let centered = [f64::midpoint(left, right), f64::midpoint(top, bottom)];
    assert!((middle[0] - centered[0]).abs() < 1.0 && (middle[1] - centered[1]).abs() < 1.0);
}

#[test]
fn a_hole_in_an_area_stays_empty() {
    let outer = ball(DVec3::ZERO, 3.0, SurfaceKind::Medium);
    let inner = ball(DVec3::ZERO, 2.0, SurfaceKind::Medium);
    let ring = CrossSection { outlines: [outer.outlines, inner.outlines].concat(), ..outer };
    let plot = PathPlot { range: PlotRange::Objects, surfaces: vec![ring], bound: None, ..all(Vec::new()) };
    let picture = png("ring.png", |path| plot_paths(path, &plot).unwrap());
    // A line through the object, which also crosses lines of the grid.
    let tinted = |x: u32, y: u32| picture.get_pixel(x, y).0 != [255; 3];
    let row: Vec<bool> = (200..1300).map(|x| tinted(x, 590)).collect();
    let changes = row.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert!(changes >= 8, "{changes} changes along a line through a ring");
    let white = row.iter().filter(|tinted| !**tinted).count();
    assert!(white > 700, "{white} of 1100 pixels are empty");
}

#[test]
fn bent_arcs_are_curves_and_straight_ones_lines() {
    let arc = [[-2.0, 0.0, 0.0], [-1.0, 0.0, 2.0], [1.0, 0.0, 2.0], [2.0, 0.0, 0.0]].map(DVec3::from);
    let bent = PathLine { curve: Curve(vec![arc]), status: "escaped" };
    let straight = PathLine { curve: Curve::through(&[arc[0], arc[3]]), status: "hit" };
    let svg = svg("curves.svg", |path| plot_paths(path, &PathPlot::new(plane(), vec![bent, straight])).unwrap());
    let strokes: Vec<_> = paths(&svg).into_iter().filter(|(line, _)| line.contains("fill=\"none\"")).collect();
    let [(bent, points), (straight, ends)] = &strokes[..] else { panic!("{}", strokes.len()) };
    assert!(bent.contains(" C") && points.len() == 4, "{bent}");
    assert!(straight.contains(" L") && ends.len() == 2, "{straight}");
    assert_eq!(format!("{:?}", [points[0], points[3]]), format!("{ends:?}"), "{bent} {straight}");
}

#[test]
fn foci_and_windings_are_marked_and_written() {
    let focus = |x: f64, real| Focus { place: DVec3::new(x, 0.0, 2.0), spread: 0.012_34, real };
    let turns = (0..12).map(|i| f64::from(i) / 8.0).collect();
    let plot = PathPlot {
        foci: vec![focus(1.0, true), focus(-3.0, false), focus(40.0, true)],
        windings: Some((DVec3::ZERO, turns)),
        ..all(lines())
    };
    let svg = svg("marks.svg", |path| plot_paths(path, &plot).unwrap());
    for text in
        ["F1 [1, 2]", "F2 [-3, 2] (continued)", "spread 0.01234", "turns around [0, 0]", ">F1<", ">F2<", ">0.12<"]
    {
        assert!(svg.contains(text), "{text}");
    }
    // The focus is outside the frame.
    assert!(svg.contains("F3 [40, 2]") && !svg.contains(">F3<"));
    // Labels do not overlap.
    let labels =
        svg.lines().filter(|line| line.starts_with("<text") && line.contains('.') && line.ends_with("</text>"));
    let turns =
        labels.filter(|line| line.contains("text-anchor=\"middle\"") && line.split('>').nth(1).unwrap().contains('.'));
    let places: Vec<_> = turns.map(numbers).map(|n| [n[1], n[2]]).collect();
    assert!(places.len() >= 2, "{places:?}");
    for (i, a) in places.iter().enumerate() {
        let apart = |b: &[f64; 2]| (a[0] - b[0]).abs() >= 62.0 || (a[1] - b[1]).abs() >= 27.5;
        assert!(places[i + 1..].iter().all(apart), "{places:?}");
    }
    png("marks.png", |path| plot_paths(path, &plot).unwrap());
}

#[test]
fn an_oblique_plane_names_its_directions() {
    let normal = DMat3::from_rotation_z(0.5) * DVec3::X;
    let plot = PathPlot::new(CutPlane::new(DVec3::ZERO, normal).unwrap(), lines());
    let svg = svg("oblique.svg", |path| plot_paths(path, &plot).unwrap());
    for text in ["along [-0.48, 0.88, 0.00] (scene units)", "z (scene units)", "rays leave the plane"] {
        assert!(svg.contains(text), "{text}");
    }
}

#[test]
fn what_is_far_larger_than_the_window_is_drawn_in_it() {
    let far = 1e7;
    let line = |y: f64, status| PathLine {
        curve: Curve::through(&[DVec3::new(-far, 0.0, y), DVec3::new(far, 0.0, y)]),
        status,
    };
    let plot = PathPlot {
        range: PlotRange::Given([-1.0, 1.0, -1.0, 1.0]),
        surfaces: vec![ball(DVec3::new(0.0, 0.0, -far), far, SurfaceKind::Limit("r = R"))],
        ..PathPlot::new(plane(), vec![line(0.5, "escaped"), line(-0.5, "captured")])
    };
    let svg = svg("far.svg", |path| plot_paths(path, &plot).unwrap());
    let [left, top, right, bottom] = window(&svg);
    let strokes: Vec<_> = paths(&svg).into_iter().filter(|(line, _)| line.contains("fill=\"none\"")).collect();
    assert_eq!(strokes.len(), 3);
    let ends = |k: usize| [strokes[k].1[0], *strokes[k].1.last().unwrap()];
    let unit = (bottom - top) / 2.0;
    for (k, z) in [(1, 0.5), (2, -0.5)] {
        let y = f64::midpoint(top, bottom) - z * unit;
        for ([x, found], side) in ends(k).into_iter().zip([left, right]) {
            assert!((x - side).abs() < 0.02 && (found - y).abs() < 0.02, "[{x}, {found}]");
        }
    }
    // The dashes of the second path cover half of it.
    let picture = png("far.png", |path| plot_paths(path, &plot).unwrap());
    let row = (f64::midpoint(top, bottom) + 0.5 * unit) as u32;
    let dashed = (left as u32..right as u32).filter(|x| picture.get_pixel(*x, row).0 == [0xd5, 0x5e, 0]).count();
    let part = dashed as f64 / (right - left);
    assert!((0.6..0.72).contains(&part), "{part} of the row is dash");
}

#[test]
fn a_path_through_the_window_is_seen_from_edge_to_edge() {
    // Parabolas, for which the third order is zero except for rounding.
    let through = |i: u32| {
        let [a, b, c] =
            [[-30.0, 0.3 * f64::from(i)], [1.0, f64::from(i)], [30.0, 0.7]].map(|[x, z]| DVec3::new(x, 0.0, z));
        Curve(vec![[a, a.lerp(b, 2.0 / 3.0), c.lerp(b, 2.0 / 3.0), c]])
    };
    let lines = (0..12).map(|i| PathLine { curve: through(i), status: "escaped" }).collect();
    let plot = PathPlot { range: PlotRange::Given([-12.0, 12.0, -9.0, 9.0]), ..PathPlot::new(plane(), lines) };
    let svg = svg("through.svg", |path| plot_paths(path, &plot).unwrap());
    let [left, _, right, _] = window(&svg);
    let strokes: Vec<_> = paths(&svg).into_iter().filter(|(line, _)| line.contains("fill=\"none\"")).collect();
    assert_eq!(strokes.len(), 12);
    for (line, points) in strokes {
        let ends = [points[0][0], points.last().unwrap()[0]];
        assert!((ends[0] - left).abs() < 0.03 && (ends[1] - right).abs() < 0.03, "{line}");
    }
}
