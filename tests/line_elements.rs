//! Light in spacetimes whose line elements users write.

use bentray::assets::Transform;
use bentray::render::{RenderSettings, Status, trace};
use glam::DVec3;

use crate::oracle::{rows, traced, vector};
use crate::support::{gpu, scene};

/// Compares with series around black holes: line elements as a user writes them, with and without t; in 32 bits also rotated and displaced.
#[test]
fn rays_by_line_elements_end_where_series_say() {
    let rows = rows(include_str!("tables/line_elements.tsv"));
    let gpu = gpu();
    let elsewhere = (DVec3::new(30.0, -50.0, 70.0), DVec3::new(0.5, -0.25, 0.125));
    let ways = [("f32", elsewhere, 1e-6, 2e-5_f64, 40.0), ("f64", (DVec3::ZERO, DVec3::ZERO), 1e-12, 1e-9, 0.0)];
    for (precision, (degrees, shift), tolerance, floor, factor) in ways {
        let turn = Transform::new(DVec3::ONE, degrees, DVec3::ZERO).0.matrix3;
        let scene_of = |row: &[&str]| {
            format!(
                "[law]\n{}\ncenter = {:?}\nrotate = {:?}\n[rays]\nmethod = \"dormand-prince\"\ntolerance = {tolerance}\n\
                 precision = \"{precision}\"\nmax_segments = 20000\n{}\n",
                row[1].replace(';', "\n"),
                shift.to_array(),
                degrees.to_array(),
                row[2].replace(';', "\n").replace("{radius", &format!("{{ center = {:?}, radius", shift.to_array())),
            )
        };
        let start = |row: &[&str]| (shift + turn * vector(row[3]), turn * vector(row[4]));
        for (row, end) in rows.iter().zip(traced(&gpu, &rows, scene_of, start)) {
            assert_eq!(end.status.name(), row[5], "{} in {precision}", row[0]);
            let number = |i: usize| row[i].parse::<f64>().unwrap();
            let size = vector(row[6]).length();
            let time = if row[8].is_empty() { 0.0 } else { (end.tau - number(8)).abs() / size };
            for (what, error, bound) in [
                (
                    "position",
                    DVec3::from(end.x).distance(shift + turn * vector(row[6])) / size,
                    factor * number(9) / size,
                ),
                ("direction", DVec3::from(end.v).normalize().distance(turn * vector(row[7])), factor * number(10)),
                ("time", time, factor * number(9) / size),
            ] {
                let bound = floor.max(bound);
                println!("{} in {precision}: {what} {:.3} of the bound", row[0], error / bound);
                assert!(error <= bound, "{} in {precision}: {what} off by {error:e}", row[0]);
            }
        }
    }
}

/// If a line element has no derivative, or no space at one time, a ray fails and never ends otherwise.
#[test]
fn rays_without_a_line_element_fail() {
    let gpu = gpu();
    for (element, x, v, fate) in [
        ("-dt^2 + dx^2 + dy^2 + (1 + abs(z)/9)*dz^2", DVec3::ZERO, DVec3::X, Status::Failed),
        ("-dt^2 + dx^2 + dy^2 + (1 + abs(z)/9)*dz^2", DVec3::Z, DVec3::X, Status::Escaped),
        ("-dt^2 + (5 - r)*dx^2 + dy^2 + dz^2", DVec3::ZERO, DVec3::X, Status::Failed),
        ("-dt^2 - dx^2 - dy^2 - dz^2", DVec3::ZERO, DVec3::X, Status::Failed),
        ("dt^2 + dx^2 + dy^2 + dz^2", DVec3::ZERO, DVec3::X, Status::Failed),
    ] {
        for method in ["rk4", "dormand-prince"] {
            let scene = scene(&format!(
                "[law]\nkind = \"metric\"\nline_element = \"{element}\"\nscale = \"3\"\n[rays]\nbounding_sphere = {{ radius = 9 }}\n\
                 method = \"{method}\"\n"
            ));
            let ray = [x.x, x.y, x.z, v.x, v.y, v.z];
            let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &[ray]).unwrap();
            assert_eq!(ends[0].status, fate, "{element} by {method}");
        }
    }
}
