//! Plots say what they show; `BENTRAY_PLOTS` names a folder to keep them in, to be looked at.

use std::{fs, path::PathBuf};

use super::folder;
use crate::output::plot::{Chart, PathLine, Series, plot_lines, plot_paths};

/// Runs a plot and returns its SVG.
fn svg(name: &str, plot: impl FnOnce(&PathBuf)) -> String {
    let folder = folder();
    let kept = std::env::var_os("BENTRAY_PLOTS").map(PathBuf::from);
    let path = kept.as_deref().unwrap_or(folder.path()).join(name);
    plot(&path);
    fs::read_to_string(path).unwrap()
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
    assert!(svg.contains("2 points have no place"));
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

/// Straight lines past a centre, bent towards it, in the plane of x and z.
fn lines() -> Vec<PathLine<'static>> {
    let status = ["escaped", "captured", "hit", "step limit"];
    (0..12)
        .map(|i| {
            let impact = -6.0 + f64::from(i);
            let path = |t: f64| [t, 0.01 * t, impact - impact * (t + 10.0).powi(2) / 300.0];
            PathLine {
                points: (0..200).map(|k| path(-10.0 + f64::from(k) * 0.09)).collect(),
                status: status[i as usize % 4],
            }
        })
        .collect()
}

#[test]
fn paths_are_shown_along_their_narrowest_axis() {
    let mut lines = lines();
    lines[3].points[100] = [f64::NAN; 3];
    let bound = Some(([0.0; 3], 12.0));
    let svg = svg("paths.svg", |path| plot_paths(path, &lines, bound).unwrap());
    for text in ["x (scene units)", "z (scene units)", "escaped", "step limit", "bound"] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(!svg.contains("y (scene units)"));
}

#[test]
fn no_paths_are_drawn_too() {
    let svg = svg("none.svg", |path| plot_paths(path, &[], None).unwrap());
    assert!(svg.contains("x (scene units)") && svg.contains("y (scene units)"));
}
