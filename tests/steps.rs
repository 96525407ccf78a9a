//! Tests the number of steps of the rays of a dozen scenes: a loss of efficiency appears as more steps, even on a busy machine.

use std::fmt::Write as _;
use std::path::Path;

use bentray::render::{RenderSettings, Renderer};
use bentray::scene::{Override, Scene};

use crate::support::gpu;

/// The table `tests/tables/steps.tsv`: a scene, its changes, and the mean steps, rejected tries and segments of a ray.
const TABLE: &str = include_str!("tables/steps.tsv");
/// Rounding depends on the device, and rays at a threshold may end a step earlier or later.
const NOISE: f64 = 0.01;

/// Returns the mean steps, rejected tries and segments of a ray.
fn taken(scene: &str, changes: &str) -> [f64; 3] {
    let size = ["image.size=[96, 54]", "image.samples=1"];
    let changes = changes.split_whitespace().chain(size);
    let changes: Vec<Override> = changes.map(|change| change.parse().unwrap()).collect();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(scene);
    let scene = Scene::load(&path, &changes).unwrap_or_else(|error| panic!("{error}"));
    let gpu = gpu();
    let picture = Renderer::new(&gpu, &scene, RenderSettings::default()).unwrap().render().unwrap();
    let totals = picture.totals;
    [totals.steps, totals.rejected, totals.segments].map(|count| count as f64 / totals.rays as f64)
}

#[test]
fn rays_take_as_many_steps_as_they_did() {
    let mut wrong = String::new();
    let rows: Vec<Vec<&str>> =
        TABLE.lines().filter(|line| !line.starts_with('#')).map(|line| line.split('\t').collect()).collect();
    assert!(rows.len() >= 12);
    for row in &rows {
        let found = taken(row[0], row[1]);
        let known = [2, 3, 4].map(|k| row[k].parse::<f64>().unwrap());
        let is_same = |(found, known): (&f64, &f64)| (found - known).abs() <= NOISE * known + 1e-3;
        if !found.iter().zip(&known).all(is_same) {
            let [steps, rejected, segments] = found;
            writeln!(wrong, "{}\t{}\t{steps:.4}\t{rejected:.4}\t{segments:.4}", row[0], row[1]).unwrap();
        }
    }
    assert!(wrong.is_empty(), "the table differs; if rays take fewer steps, replace these rows:\n{wrong}");
}
