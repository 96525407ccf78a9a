//! Tests of work–precision diagrams.

use proptest::prelude::*;

use super::plots::{png, svg};
use crate::output::plot::{PrecisionPlot, Series, pareto_front, plot_precision};

/// The greatest error that counts as rounding.
const FLOOR: f64 = 3e-7;

const METHODS: [(&str, i32, f64); 14] = [
    ("Euler", 1, 1.0),
    ("Euler doubling, the paper's", 1, 1.9),
    ("Euler doubling, rejecting", 1, 2.3),
    ("midpoint", 2, 1.8),
    ("Heun", 2, 2.0),
    ("leapfrog", 2, 1.1),
    ("Störmer–Verlet", 2, 1.3),
    ("RK4", 4, 3.6),
    ("RK4 doubling", 4, 8.1),
    ("Bogacki–Shampine 3(2)", 3, 3.3),
    ("Cash–Karp 5(4)", 5, 6.2),
    ("Dormand–Prince 5(4)", 5, 6.4),
    ("Yoshida 4", 4, 3.2),
    ("Gauss–Legendre 6", 6, 14.0),
];

/// Returns `methods` curves with halved steps, whose errors end at the floor.
fn example(methods: usize) -> PrecisionPlot {
    let curves = METHODS[..methods].iter().enumerate().map(|(k, (name, order, cost))| {
        let point = |i: i32| {
            let h = 2f64.powi(-i);
            let wobble = 1.0 + 0.4 * f64::from(i * 7 + i32::try_from(k).unwrap() * 3).sin();
            [FLOOR * wobble + 0.3 * cost * h.powi(*order) / 4f64.powi(*order), cost * 40.0 / h]
        };
        Series { name: (*name).into(), points: (0..9).map(point).collect() }
    });
    PrecisionPlot {
        title: "Deflection by a black hole: time against error".into(),
        x_label: "error of the direction (rad)".into(),
        y_label: "time per ray (ns)".into(),
        curves: curves.collect(),
        floor: Some(FLOOR),
    }
}

#[test]
fn a_precision_plot_names_its_parts() {
    let plot = example(12);
    let svg = svg("precision.svg", |path| plot_precision(path, &plot).unwrap());
    for text in ["error of the direction", "time per ray", "smallest error", "Pareto front", "1e-6", "Gauss"] {
        assert_eq!(svg.contains(text), text != "Gauss", "{text}");
    }
    for (name, ..) in &METHODS[..12] {
        assert!(svg.contains(&name.replace('\'', "&apos;")) || svg.contains(name), "{name}");
    }
    png("precision.png", |path| plot_precision(path, &plot).unwrap());
    png("precision14.png", |path| plot_precision(path, &example(14)).unwrap());
}

#[test]
fn it_rings_the_front_and_counts_what_it_cannot_show() {
    let mut plot = example(3);
    let rings = |plot: &PrecisionPlot| {
        let svg = svg("rings.svg", |path| plot_precision(path, plot).unwrap());
        // One ring is in the legend.
        let is_ring = |line: &&str| line.contains("fill=\"white\"") && line.contains("stroke-width=\"2\"");
        (svg.lines().filter(is_ring).count() - 1, svg)
    };
    assert_eq!(rings(&plot).0, plot.front().len());
    plot.curves[0].points[4] = [f64::NAN, 1.0];
    plot.curves[1].points[2] = [0.0, 1e-9];
    plot.curves[2].points[5] = [1e-12, f64::INFINITY];
    plot.curves[2].points[6] = [1e-12, -1.0];
    let (count, svg) = rings(&plot);
    assert_eq!(count, plot.front().len());
    assert!(svg.contains("4 points cannot be shown") && !svg.contains("wrong"));
    // A gross error has a separate line, even without other errors there.
    plot.curves[2].points[6] = [f64::INFINITY, 30.0];
    let (count, svg) = rings(&plot);
    assert_eq!(count, plot.front().len());
    assert!(svg.contains("3 points cannot be shown") && svg.contains("wrong"));
    plot.curves = vec![Series { name: "a".into(), points: vec![[f64::INFINITY, 2.0]] }];
    plot.floor = None;
    assert!(super::plots::svg("wrong.svg", |path| plot_precision(path, &plot).unwrap()).contains("wrong"));
}

#[test]
fn odd_precision_plots_are_drawn() {
    let nothing = PrecisionPlot::default();
    let svg = svg("empty.svg", |path| plot_precision(path, &nothing).unwrap());
    assert!(!svg.contains("floor") && !svg.contains("Pareto"));
    for (i, floor) in [None, Some(0.0), Some(f64::NAN), Some(1e-3), Some(1e-9), Some(1e3)].into_iter().enumerate() {
        let curves = vec![Series { name: "a".into(), points: vec![[1e-3, 2.0]] }];
        let plot = PrecisionPlot { curves, floor, ..PrecisionPlot::default() };
        png(&format!("oddfloor{i}.png"), |path| plot_precision(path, &plot).unwrap());
    }
}

/// Returns coordinates that often agree, and some that are not finite.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => (-3i32..6).prop_map(f64::from),
        4 => 1e-9..1e3f64,
        1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0]),
    ]
}

fn points() -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop::collection::vec([coordinate(), coordinate()], 0..30)
}

fn is_finite(point: &[f64; 2]) -> bool {
    point.iter().all(|v| v.is_finite())
}

/// Returns `true` if a point is at least as good as another in both coordinates, and better in one.
fn dominates(a: &[f64; 2], b: &[f64; 2]) -> bool {
    is_finite(a) && a[0] <= b[0] && a[1] <= b[1] && (a[0] < b[0] || a[1] < b[1])
}

proptest! {
    #[test]
    fn the_front_is_what_nothing_dominates(points in points()) {
        let front = pareto_front(&points);
        for (i, point) in points.iter().enumerate() {
            let best = is_finite(point) && !points.iter().any(|other| dominates(other, point));
            prop_assert_eq!(front.contains(&i), best, "{:?}", point);
        }
        for pair in front.windows(2) {
            let [a, b] = [points[pair[0]], points[pair[1]]];
            prop_assert!(pair[0] != pair[1] && a[0] <= b[0] && a[1] >= b[1]);
        }
    }

    #[test]
    fn the_front_of_a_plot_is_that_of_what_it_shows(curves in prop::collection::vec(points(), 0..4)) {
        let curves: Vec<_> = curves.into_iter().map(|points| Series { points, ..Series::default() }).collect();
        let plot = PrecisionPlot { curves, ..PrecisionPlot::default() };
        let shown: Vec<_> = plot.curves.iter().flat_map(|c| &c.points)
            .filter(|p| is_finite(p) && p[0] > 0.0 && p[1] > 0.0).copied().collect();
        let ringed: Vec<_> = plot.front().into_iter().map(|(curve, point)| plot.curves[curve].points[point]).collect();
        let best: Vec<_> = pareto_front(&shown).into_iter().map(|i| shown[i]).collect();
        prop_assert_eq!(ringed, best);
    }
}
