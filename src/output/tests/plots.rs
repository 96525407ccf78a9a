//! Tests of plots; `BENTRAY_PLOTS` is the path of a folder that receives the plots for inspection.

use std::{
    fs,
    path::{Path, PathBuf},
};

use image::{ColorType, Rgb, RgbImage};

use super::diagrams::{all, lines, points};
use super::{folder, names};
use crate::output::{
    OutputError,
    plot::{Chart, Series, check_plot, plot_lines, plot_paths},
};

/// Draws a plot and returns its file.
pub(super) fn bytes(name: &str, plot: impl FnOnce(&Path)) -> Vec<u8> {
    let folder = folder();
    let kept = std::env::var_os("BENTRAY_PLOTS").map(PathBuf::from);
    let path = kept.as_deref().unwrap_or(folder.path()).join(name);
    plot(&path);
    fs::read(path).unwrap()
}

/// Draws a plot and returns its SVG.
pub(super) fn svg(name: &str, plot: impl FnOnce(&Path)) -> String {
    String::from_utf8(bytes(name, plot)).unwrap()
}

/// Draws a plot and returns its PNG, after a check that it has the canvas size, a white edge and contents.
pub(super) fn png(name: &str, plot: impl FnOnce(&Path)) -> RgbImage {
    let picture = image::load_from_memory(&bytes(name, plot)).unwrap();
    assert_eq!(picture.color(), ColorType::Rgb8);
    let picture = picture.to_rgb8();
    assert_eq!(picture.dimensions(), (1600, 1200));
    let white = Rgb([255; 3]);
    let mut edge = (0..1600).flat_map(|x| [(x, 0), (x, 1199)]).chain((0..1200).flat_map(|y| [(0, y), (1599, y)]));
    assert!(edge.all(|(x, y)| *picture.get_pixel(x, y) == white));
    assert!(picture.pixels().filter(|p| **p != white).count() > 2000);
    picture
}

fn chart(log: bool) -> Chart {
    let names = ["Störmer–Verlet <2>", "Runge–Kutta 4", "Dormand–Prince 5 & dense", "Gauss 6"];
    let series = (2..6).zip(names).map(|(order, name)| Series {
        name: name.into(),
        points: (0..30).map(|i| 2f64.powf(-f64::from(i) / 3.0)).map(|h| [h, 0.1 * h.powi(order)]).collect(),
    });
    Chart {
        title: "Error of one orbit against the step".into(),
        x_label: "step (M)".into(),
        y_label: "error of position (M)".into(),
        log_x: log,
        log_y: log,
        series: series.collect(),
    }
}

#[test]
fn a_chart_names_its_parts() {
    for (name, log) in [("log.svg", true), ("linear.svg", false)] {
        let svg = svg(name, |path| plot_lines(path, &chart(log)).unwrap());
        for text in ["Error of one orbit", "step (M)", "error of position", "Störmer–Verlet &lt;2&gt;"] {
            assert!(svg.contains(text), "{text}");
        }
        assert_eq!(svg.contains("1e-"), log, "{name}");
    }
}

#[test]
fn a_chart_counts_what_it_cannot_show() {
    let mut chart = chart(true);
    chart.series.truncate(1);
    chart.series[0].points[10][1] = 0.0;
    chart.series[0].points[20][0] = f64::NAN;
    let svg = svg("gaps.svg", |path| plot_lines(path, &chart).unwrap());
    assert!(svg.contains("2 points cannot be shown"));
}

#[test]
fn odd_charts_are_drawn() {
    let points = [vec![], vec![[0.0, 0.0]], vec![[3.0, 5.0]; 4], vec![[1e9, 1.0], [1e9 + 1.0, 2.0]]];
    for (i, points) in points.into_iter().enumerate() {
        let chart = Chart { series: vec![Series { name: "a".into(), points }], ..Chart::default() };
        svg(&format!("odd{i}.svg"), |path| plot_lines(path, &chart).unwrap());
    }
    let many = Chart {
        series: (0..60)
            .map(|i| Series {
                name: format!("series {i} with a rather long name"),
                points: vec![[0.0, f64::from(i)], [1.0, 2.0 * f64::from(i)]],
            })
            .collect(),
        ..Chart::default()
    };
    let svg = svg("many.svg", |path| plot_lines(path, &many).unwrap());
    assert!(svg.contains("and 36 more"), "{}", svg.len());
}

/// Returns the extent of an image's contents, `[left, top, right, bottom]`.
fn extent(picture: &RgbImage) -> [u32; 4] {
    let drawn = picture.enumerate_pixels().filter(|(_, _, p)| **p != Rgb([255; 3]));
    drawn.fold([u32::MAX, u32::MAX, 0, 0], |[l, t, r, b], (x, y, _)| [l.min(x), t.min(y), r.max(x), b.max(y)])
}

#[test]
fn a_png_shows_the_colours_and_words_of_the_svg() {
    let picture = png("log.png", |path| plot_lines(path, &chart(true)).unwrap());
    for color in [[0x00, 0x72, 0xb2], [0xd5, 0x5e, 0x00], [0x00, 0x9e, 0x73], [0xcc, 0x79, 0xa7], [0, 0, 0]] {
        assert!(picture.pixels().filter(|p| p.0 == color).count() > 100, "{color:?}");
    }
    // The title is at the top, the name of the y axis at the left, the legend at the right.
    let [left, top, right, bottom] = extent(&picture);
    assert!(left < 100 && top < 70 && right > 1400 && bottom > 1130, "{left} {top} {right} {bottom}");
    let wordless = Chart {
        title: String::new(),
        y_label: String::new(),
        series: vec![Series { points: vec![[1.0, 1.0], [2.0, 2.0]], ..Series::default() }],
        ..chart(true)
    };
    let [left, top, ..] = extent(&png("wordless.png", |path| plot_lines(path, &wordless).unwrap()));
    assert!(left >= 30 && top >= 30, "{left} {top}");
    let lines = lines();
    png("paths.PNG", |path| plot_paths(path, &all(lines)).unwrap());
}

/// Returns the position of a label by its text, `[x, y]` of its center line.
fn label(svg: &str, align: &str, text: &str) -> [f64; 2] {
    let is_label = |line: &&str| line.contains(&format!("\"{align}\"")) && line.ends_with(&format!(">{text}</text>"));
    let line = svg.lines().find(is_label).unwrap_or_else(|| panic!("no {text}"));
    let number = |name: &str| line.split(name).nth(1).unwrap().split('"').next().unwrap().parse::<f64>().unwrap();
    [number(" x=\""), number(" y=\"") - 0.35 * number("font-size=\"")]
}

#[test]
fn points_are_where_the_ticks_say() {
    let decades = Chart {
        log_x: true,
        log_y: true,
        series: vec![Series {
            name: "a".into(),
            points: (0..5).map(|i| [10f64.powi(i), 10f64.powi(2 * i - 4)]).collect(),
        }],
        ..Chart::default()
    };
    let thirds = Chart {
        series: vec![Series { name: "a".into(), points: vec![[0.0, 3.0], [2.0, -1.0], [4.0, 1.0]] }],
        ..Chart::default()
    };
    let cases: [(&Chart, &[[&str; 2]]); 2] = [
        (&decades, &[["1", "1e-4"], ["10", "0.01"], ["100", "1"], ["1000", "100"], ["10000", "10000"]]),
        (&thirds, &[["0", "3"], ["2", "-1"], ["4", "1"]]),
    ];
    for (k, (chart, ticks)) in cases.into_iter().enumerate() {
        let svg = svg(&format!("ticks{k}.svg"), |path| plot_lines(path, chart).unwrap());
        let picture = png(&format!("ticks{k}.png"), |path| plot_lines(path, chart).unwrap());
        let curve = svg.lines().find(|line| line.contains("stroke=\"#0072b2\"")).unwrap();
        let places = points(curve);
        assert_eq!(places.len(), ticks.len());
        for ([x, y], [x_tick, y_tick]) in places.into_iter().zip(ticks) {
            let expected = [label(&svg, "middle", x_tick)[0], label(&svg, "end", y_tick)[1]];
            assert!((x - expected[0]).abs() < 0.02 && (y - expected[1]).abs() < 0.02, "[{x}, {y}] {expected:?}");
            // The marker, which is a disk.
            assert_eq!(picture.get_pixel(x as u32, y as u32).0, [0, 0x72, 0xb2]);
        }
    }
}

#[test]
fn letters_beyond_ascii_have_shapes() {
    let title = |text: &str| {
        let chart = Chart { title: text.into(), ..Chart::default() };
        png("letter.png", |path| plot_lines(path, &chart).unwrap())
    };
    // The last character is in no font.
    let letters = ["τ", "η", "µ", "μ", "θ", "ψ", "°", "–", "…", "×", "ö", "²", "\u{10fffd}"];
    let pictures = letters.map(title);
    for (i, one) in pictures.iter().enumerate() {
        for (k, other) in pictures.iter().enumerate().skip(i + 1) {
            assert!(one != other || [letters[i], letters[k]] == ["µ", "μ"], "{} {}", letters[i], letters[k]);
        }
    }
}

#[test]
fn the_same_plot_gives_the_same_bytes() {
    for name in ["same.svg", "same.png"] {
        let [first, second] = [0, 1].map(|_| bytes(name, |path| plot_lines(path, &chart(true)).unwrap()));
        assert!(first == second, "{name}");
        let [first, second] = [0, 1].map(|_| bytes(name, |path| plot_paths(path, &all(lines())).unwrap()));
        assert!(first == second, "{name}");
    }
}

#[test]
fn a_name_that_is_no_plot_is_refused_before_the_work() {
    let folder = folder();
    for name in ["a.pdf", "a", "svg", "a.svg.gz"] {
        let path = folder.path().join(name);
        for error in [check_plot(&path), plot_lines(&path, &chart(true)), plot_paths(&path, &all(Vec::new()))] {
            let error = error.unwrap_err();
            assert!(matches!(error, OutputError::PlotFormat { .. }), "{error}");
            assert!(error.to_string().contains(name) && error.to_string().contains(".svg"), "{error}");
        }
    }
    let lost = check_plot(&folder.path().join("no/a.svg")).unwrap_err();
    assert!(matches!(lost, OutputError::MissingFolder { .. }), "{lost}");
    check_plot(&folder.path().join("a.png")).unwrap();
    assert!(names(folder.path()).is_empty());
}
