//! Compares traced rays with answers to 15 digits, from closed forms and high-order series.

use std::collections::BTreeMap;

use bentray::gpu::Gpu;
use bentray::measure::drift;
use bentray::render::{RenderSettings, Status, Traced, trace};
use glam::DVec3;

use crate::support::{gpu, scene};

pub fn vector(text: &str) -> DVec3 {
    let numbers: Vec<f64> = text.split(' ').map(|word| word.parse().unwrap()).collect();
    DVec3::new(numbers[0], numbers[1], numbers[2])
}

/// Returns the traced rows of a table, grouped by scene, because each distinct one requires a compilation.
pub fn traced<'t>(
    gpu: &Gpu,
    rows: &[Vec<&'t str>],
    scene_of: impl Fn(&[&'t str]) -> String,
    ray_of: impl Fn(&[&'t str]) -> (DVec3, DVec3),
) -> Vec<Traced> {
    let mut groups: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (i, row) in rows.iter().enumerate() {
        groups.entry(scene_of(row)).or_default().push(i);
    }
    let mut ends = vec![None; rows.len()];
    for (text, members) in groups {
        let rays: Vec<[f64; 6]> = members
            .iter()
            .map(|&i| {
                let (x, v) = ray_of(&rows[i]);
                [x.x, x.y, x.z, v.x, v.y, v.z]
            })
            .collect();
        let (results, _) = trace(gpu, &scene(&text), &RenderSettings::default(), &rays).unwrap();
        for (i, end) in members.into_iter().zip(results) {
            ends[i] = Some(end);
        }
    }
    ends.into_iter().map(Option::unwrap).collect()
}

pub fn rows(table: &str) -> Vec<Vec<&str>> {
    table.lines().filter(|line| !line.starts_with('#')).map(|line| line.split('\t').collect()).collect()
}

/// RK4 at η = 0.03 has an error below that of float32. The bound is 2e-5, or 40 times the effect of one rounding of the
/// input on the answer (a path has about 40 times as many roundings).
#[test]
fn rays_end_where_closed_forms_say() {
    let rows = rows(include_str!("tables/ends.tsv"));
    let gpu = gpu();
    let scene_of = |row: &[&str]| {
        let law = row[1].replace(';', "\n");
        format!(
            "[law]\n{law}\n[rays]\nscaled_step = 0.03\nmax_segments = 4000\nbounding_sphere = {{ radius = {} }}\n",
            row[2]
        )
    };
    let ends = traced(&gpu, &rows, scene_of, |row| (vector(row[3]), vector(row[4])));
    for (row, end) in rows.iter().zip(ends) {
        assert_eq!(end.status.name(), row[5], "{}", row[0]);
        let (radius, sensitivity) = (row[2].parse::<f64>().unwrap(), row[8].parse::<f64>().unwrap());
        let position = DVec3::from(end.x).distance(vector(row[6])) / radius;
        assert!(
            position <= (40.0 * sensitivity / radius).max(2e-5),
            "{}: position off by {position:e} of the bound",
            row[0]
        );
        let direction = DVec3::from(end.v).normalize().distance(vector(row[7]));
        let sensitivity = row[9].parse::<f64>().unwrap();
        assert!(direction <= (40.0 * sensitivity).max(2e-5), "{}: direction off by {direction:e}", row[0]);
    }
}

/// Media that fill all space, with an embedded pair: bounds in 32 bits as above,
/// and 1e-9 in 64. |v| = n holds at the ends with the accuracy of their positions.
#[test]
fn rays_of_media_end_where_closed_forms_say() {
    let rows = rows(include_str!("tables/media.tsv"));
    let gpu = gpu();
    for (precision, tolerance, floor, factor) in [("f32", 1e-6, 2e-5_f64, 40.0), ("f64", 1e-13, 1e-9, 0.0)] {
        let scene_of = |row: &[&str]| {
            let stop = row[2].replace(';', "\n");
            format!(
                "[law]\nkind = \"medium\"\nindex = {}\n[rays]\nmethod = \"dormand-prince\"\ntolerance = {tolerance}\n\
                 precision = \"{precision}\"\nmax_segments = 20000\nbounding_sphere = {{ radius = {} }}\n{stop}\n",
                row[1], row[3]
            )
        };
        let ends = traced(&gpu, &rows, scene_of, |row| (vector(row[4]), vector(row[5])));
        let mut worst = [0.0_f64; 3];
        for (row, end) in rows.iter().zip(ends) {
            let number = |i: usize| row[i].parse::<f64>().unwrap();
            assert_eq!(end.status.name(), row[6], "{} in {precision}", row[0]);
            let (radius, law) = (number(3), scene(&scene_of(row)).law);
            let position = DVec3::from(end.x).distance(vector(row[7])) / radius;
            let direction = DVec3::from(end.v).normalize().distance(vector(row[8]));
            let start = [vector(row[4]), law.starting_velocity(vector(row[4]), vector(row[5]))];
            let [(_, drifted)] = drift(&*law, [(start, &end)].into_iter())[..] else {
                panic!("{}: the law has no constants of motion", row[0])
            };
            let bounds = [floor.max(factor * number(9) / radius), floor.max(factor * number(10)), floor];
            for (k, error) in [position, direction, drifted.max].into_iter().enumerate() {
                let what = ["position", "direction", "|v| / n"][k];
                worst[k] = worst[k].max(error / bounds[k]);
                assert!(error <= bounds[k], "{} in {precision}: {what} off by {error:e}", row[0]);
            }
        }
        let worst = worst.map(|ratio| format!("{ratio:.1e}")).join(", ");
        println!("media in {precision}: at most {worst} of the bounds on position, direction and |v| / n");
    }
}

#[test]
fn flows_follow_their_orbits() {
    let rows = rows(include_str!("tables/orbits.tsv"));
    let gpu = gpu();
    let scene_of = |row: &[&str]| {
        format!(
            "[law]\nkind = \"{}\"\n[rays]\nscaled_step = 0.05\nmax_segments = 4000\nbounding_sphere = {{ radius = 500 }}\nmax_parameter = {}\n",
            row[1], row[3]
        )
    };
    let ends = traced(&gpu, &rows, scene_of, |row| (vector(row[2]), DVec3::X));
    for (row, end) in rows.iter().zip(ends) {
        assert_eq!(end.status.name(), "ended", "{}", row[0]);
        let error = DVec3::from(end.x).distance(vector(row[4])) / row[5].parse::<f64>().unwrap();
        assert!(error <= 1e-4, "{} at t = {}: off by {error:e} of the orbit's size", row[0], row[3]);
    }
}

/// Checks constants of motion: energy in a field of forces, |v| = n in a medium, and the identical path in both Schwarzschild forms.
#[test]
fn rays_keep_what_their_law_keeps() {
    let gpu = gpu();
    let explosion = "{ kind = \"explosion\", radius = 8, amplitude = 0.2, frequency = 0.5, octaves = 2 }";
    let noise = "{ kind = \"noise\", amplitude = 0.1, frequency = 0.5, octaves = 3 }";
    let rays: Vec<[f64; 6]> = (0..64).map(|i| [-9.0, 0.2 * f64::from(i) - 6.4, 0.7, 1.0, 0.0, 0.0]).collect();
    for index in [explosion, noise] {
        let medium = format!(
            "[law]\nkind = \"medium\"\nindex = {index}\n[rays]\nscaled_step = 0.05\nmax_segments = 4000\nmax_parameter = 9\n\
             bounding_sphere = {{ radius = 20 }}\n"
        );
        // A ray of the medium that is restarted at its end starts with |v| = n there, so it must have ended with that.
        let (ends, _) = trace(&gpu, &scene(&medium), &RenderSettings::default(), &rays).unwrap();
        let short = medium.replace("max_parameter = 9", "max_parameter = 1e-6");
        let again: Vec<[f64; 6]> =
            ends.iter().map(|e| [e.x[0], e.x[1], e.x[2], e.v[0], e.v[1], e.v[2]].map(f64::from)).collect();
        let (starts, _) = trace(&gpu, &scene(&short), &RenderSettings::default(), &again).unwrap();
        for (end, start) in ends.iter().zip(starts) {
            let (kept, index) = (DVec3::from(end.v).length(), DVec3::from(start.v).length());
            assert!((kept - index).abs() < 2e-5, "|v| = {kept}, n = {index}");
        }
    }
}

/// Checks that every kind of medium as a scene's law has |v| = n at the end of a path, with n from the CPU.
#[test]
fn speed_follows_the_index_of_every_medium() {
    let gpu = gpu();
    let rays: Vec<[f64; 6]> = (0..32).map(|i| [-3.0, 0.1 * f64::from(i) - 1.5, 0.7, 1.0, 0.2, 0.1]).collect();
    for index in [
        "1.5",
        "{ kind = \"luneburg\", radius = 4, c = 3 }",
        "{ kind = \"gaussian\", radius = 3, a = 1.5 }",
        "{ kind = \"inverse-r\", k = 4, center = [-8, 0, 0] }",
        "{ kind = \"eaton\", radius = 4 }",
        "{ kind = \"rod\", axis = [1, 0, 0.2], n0 = 1.6, g = 0.25 }",
        "{ kind = \"exponential\", delta = 0.3, height = 2 }",
        "{ kind = \"profile\", points = [[-2, 1.25], [-1, 1.375], [0, 1.125], [0.5, 1.25], [2, 1.0625], [9, 1]] }",
    ] {
        let text = format!(
            "[law]\nkind = \"medium\"\nindex = {index}\n[rays]\ntolerance = 1e-6\nmax_segments = 4000\nmax_parameter = 3\n\
             bounding_sphere = {{ radius = 20 }}\n"
        );
        let scene = scene(&text);
        let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
        assert!(ends.iter().all(|end| end.status == Status::Ended), "{index}");
        let start = |ray: &[f64; 6]| {
            let [x, v] = [DVec3::from_slice(&ray[..3]), DVec3::from_slice(&ray[3..])];
            [x, scene.law.starting_velocity(x, v)]
        };
        let [(what, drifted)] = drift(&*scene.law, rays.iter().map(start).zip(&ends))[..] else { panic!("{index}") };
        println!("{index}: {what} drifts by {:.1e}", drifted.max);
        assert!(drifted.max < 2e-5, "{index}: {what} drifts by {:e}", drifted.max);
    }
}

/// A ray that returns along its path reaches its start.
#[test]
fn paths_can_be_followed_back() {
    let gpu = gpu();
    let hole = scene(
        "[law]\nkind = \"schwarzschild\"\n[rays]\nscaled_step = 0.03\nmax_segments = 4000\nbounding_sphere = { radius = 30 }\n",
    );
    let rays: Vec<[f64; 6]> = (0..40).map(|i| [-29.9, 6.5 + 0.2 * f64::from(i), 1.0, 1.0, 0.0, 0.0]).collect();
    let (ends, _) = trace(&gpu, &hole, &RenderSettings::default(), &rays).unwrap();
    let back: Vec<[f64; 6]> =
        ends.iter().map(|e| [e.x[0], e.x[1], e.x[2], -e.v[0], -e.v[1], -e.v[2]].map(f64::from)).collect();
    let (starts, _) = trace(&gpu, &hole, &RenderSettings::default(), &back).unwrap();
    for (ray, start) in rays.iter().zip(starts) {
        let line = DVec3::new(ray[3], ray[4], ray[5]);
        let off = (DVec3::from(start.x) - DVec3::new(ray[0], ray[1], ray[2])).reject_from_normalized(line).length();
        assert!(off < 1e-2, "came back {off} from its start");
        // The rays that wind longest start half a unit outside the critical one, where errors grow a hundredfold.
        let turned = (DVec3::from(start.v).normalize() + line).length();
        assert!(turned < 2e-3, "came back turned by {turned}");
    }
}
