//! Tests light around black holes with spin and charge, against values with 15 digits and against exact relations.

use bentray::assets::Transform;
use bentray::measure::drift;
use bentray::model::Value;
use bentray::model::camera::observer;
use bentray::render::{PathPoint, RenderSettings, Status, trace, trace_paths};
use glam::{DVec3, DVec4};

use crate::oracle::{rows, traced, vector};
use crate::shaders::Random;
use crate::support::{gpu, scene};

/// Returns the law of a table's row, `kind="kerr-newman";spin=0.9`, as a user would write its line element.
pub fn typed(law: &str) -> String {
    let given = |key: &str| {
        law.split(';').find_map(|pair| pair.strip_prefix(key)?.strip_prefix('=')).map_or(0.0, |n| n.parse().unwrap())
    };
    let (a, charge): (f64, f64) = (given("spin"), given("charge"));
    // Into the past light approaches a horizon forever.
    let horizon = (1.0 - a * a - charge * charge).max(0.0).sqrt() + 1.01;
    format!(
        "kind = \"metric\"\nline_element = \"-dt^2 + dx^2 + dy^2 + dz^2 + f*l^2\"\nscale = \"R\"\ncapture_condition = \"R < horizon\"\n\
         parameters = {{ a = {a}, Q = {charge}, horizon = {horizon} }}\n\
         terms = {{ k = \"(r^2 - a^2)/2\", d = \"sqrt(k^2 + a^2*z^2)\", R = \"sqrt(k + d)\", f = \"(2*R - Q^2)/(2*d)\", \
         l = \"dt + ((R*x + a*y)*dx + (R*y - a*x)*dy)/(R^2 + a^2) + z*dz/R\" }}"
    )
}

/// Compares rays with a table: in 32 bits within 2e-5 or 40 times the effect of one rounding of the input, in 64 within 1e-9; in
/// 32 bits for a displaced black hole with another spin axis, and by its line element. Constants of motion are as accurate as the end.
#[test]
fn rays_round_spinning_holes_end_where_series_say() {
    let rows = rows(include_str!("tables/kerr_newman.tsv"));
    let gpu = gpu();
    let (there, degrees) = (DVec3::new(0.5, -0.25, 0.125), DVec3::new(30.0, -50.0, 70.0));
    let ways = [
        (false, "f32", "method = \"dormand-prince\"\ntolerance = 1e-6"),
        (true, "f32", "method = \"dormand-prince\"\ntolerance = 1e-6"),
        (false, "f32", "method = \"separated\"\nscaled_step = 0.02"),
        (false, "f64", "method = \"dormand-prince\"\ntolerance = 1e-13"),
        (true, "f64", "method = \"dormand-prince\"\ntolerance = 1e-13"),
        (false, "f64", "method = \"separated\"\nscaled_step = 0.003"),
    ];
    for (is_typed, precision, method) in ways {
        let (degrees, shift) = if precision == "f32" { (degrees, there) } else { (DVec3::ZERO, DVec3::ZERO) };
        let turn = Transform::new(DVec3::ONE, degrees, DVec3::ZERO).0.matrix3;
        let (floor, factor) = if precision == "f32" { (2e-5_f64, 40.0) } else { (1e-9, 0.0) };
        let scene_of = |row: &[&str]| {
            let (axis, center) = ((turn * DVec3::Z).to_array(), shift.to_array());
            let law = if is_typed {
                format!("{}\nrotate = {:?}", typed(row[1]), degrees.to_array())
            } else {
                format!("{}\naxis = {axis:?}", row[1].replace(';', "\n"))
            };
            format!(
                "[law]\n{law}\ncenter = {center:?}\n[rays]\n{method}\nprecision = \"{precision}\"\nmax_segments = 20000\n\
                 bounding_sphere = {{ center = {center:?}, radius = {} }}\n",
                row[2]
            )
        };
        let start = |row: &[&str]| (shift + turn * vector(row[3]), turn * vector(row[4]));
        for (row, end) in rows.iter().zip(traced(&gpu, &rows, scene_of, start)) {
            assert_eq!(end.status.name(), row[5], "{} in {precision}, {method}", row[0]);
            if end.status != Status::Escaped {
                continue;
            }
            let number = |i: usize| row[i].parse::<f64>().unwrap();
            let radius = number(2);
            let direction = factor * number(10);
            let mut errors = vec![
                (
                    "position",
                    DVec3::from(end.x).distance(shift + turn * vector(row[6])) / radius,
                    factor * number(9) / radius,
                ),
                ("direction", DVec3::from(end.v).normalize().distance(turn * vector(row[7])), direction),
            ];
            if !row[8].is_empty() {
                errors.push(("time", (end.tau - number(8)).abs() / radius, factor * number(9) / radius));
            }
            let law = scene(&scene_of(row)).law;
            let (x, v) = start(row);
            let kept = drift(&*law, [([x, law.starting_velocity(x, v)], &end)].into_iter());
            errors.extend(kept.iter().map(|(name, drifted)| (*name, drifted.max, direction)));
            for (what, error, bound) in errors {
                let bound = floor.max(bound);
                println!("{} in {precision}, {method}: {what} {:.3} of the bound", row[0], error / bound);
                assert!(error <= bound, "{} in {precision}, {method}: {what} off by {error:e}", row[0]);
            }
        }
    }
}

/// A black hole without spin and charge is a Schwarzschild one, with identical positions and paths in these coordinates.
#[test]
fn without_spin_and_charge_it_is_schwarzschilds() {
    let all = rows(include_str!("tables/ends.tsv"));
    let rows: Vec<_> =
        all.into_iter().filter(|row| row[1].contains("schwarzschild\"") && row[1].contains("orbit-equation")).collect();
    assert!(rows.len() >= 5, "{}", rows.len());
    let scene_of = |row: &[&str]| {
        let law =
            row[1].replace("schwarzschild", "kerr-newman").replace(";form=\"orbit-equation\"", "").replace(';', "\n");
        format!(
            "[law]\n{law}\n[rays]\nmethod = \"dormand-prince\"\ntolerance = 1e-12\nprecision = \"f64\"\nmax_segments = 20000\n\
             bounding_sphere = {{ radius = {} }}\n",
            row[2]
        )
    };
    for (row, end) in rows.iter().zip(traced(&gpu(), &rows, scene_of, |row| (vector(row[3]), vector(row[4])))) {
        assert_eq!(end.status.name(), row[5], "{}", row[0]);
        if end.status == Status::Escaped {
            let off = DVec3::from(end.v).normalize().distance(vector(row[7]));
            assert!(off < 1e-9, "{}: off by {off:e}", row[0]);
        }
    }
}

/// Checks an observer's right, up and forward, and that its light comes from the past, is null and has the speed of `law_start`.
#[test]
fn observers_have_the_axes_of_their_four_velocities() {
    let four = |text: &str| DVec4::from_slice(&text.split(' ').map(|n| n.parse().unwrap()).collect::<Vec<f64>>());
    let rows = rows(include_str!("tables/kerr_frames.tsv"));
    let laws = rows.iter().flat_map(|row| [row[1].replace(';', "\n"), typed(row[1])].map(|law| (row, law)));
    for (row, law) in laws.filter(|(row, law)| row[3] != "infalling" || !law.contains("metric")) {
        let (position, forward) = (vector(row[2]), vector(row[4]));
        let up = vector(row[5]).to_array();
        let camera = format!(
            "[camera]\nposition = {:?}\nlook_at = {:?}\nup = {up:?}\nobserver = \"{}\"\n",
            position.to_array(),
            (position + forward).to_array(),
            row[3]
        );
        let velocity = row.get(10).map_or(String::new(), |v| format!("velocity = {:?}\n", vector(v).to_array()));
        let scene = scene(&format!("{camera}{velocity}[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 60 }}\n"));
        let camera = scene.camera.as_ref().unwrap();
        let fed = observer(&*scene.law, camera).unwrap();
        let column = |name: &str| match fed.iter().find(|(member, _)| member == name) {
            Some((_, Value::Vec4(v))) => *v,
            _ => panic!("no {name}"),
        };
        // The circular orbits of a line element use differences.
        let bound = if law.contains("metric") { 1e-10 } else { 1e-12 };
        let along = |d: DVec3| d.x * column("x") + d.y * column("y") + d.z * column("z");
        assert!((column("rest") + four(row[6])).length() < bound, "{}: u is off", row[0]);
        for (axis, expected) in [(camera.right, 7), (camera.up, 8), (camera.forward, 9)] {
            let off = along(axis).distance(four(row[expected]));
            assert!(off < bound, "{}: an axis is off by {off:e}", row[0]);
        }
        for d in [camera.forward, camera.right, DVec3::new(0.6, -0.48, 0.64)] {
            let light = column("rest") + along(d);
            let v = light.truncate() / -light.w;
            let settled = scene.law.starting_velocity(position, v);
            assert!(light.w < 0.0 && settled.distance(v) < 10.0 * bound, "{}: {light} is from the future", row[0]);
        }
    }
}

/// Separated orbits end like those of general methods, also in bounding spheres that are off-center and on surfaces near
/// the black hole. Their ends agree, except for a few rays so close to photon orbits that 32 bits separate them.
#[test]
fn separated_orbits_end_where_others_do() {
    let gpu = gpu();
    let mut random = Random::new(85);
    let rays: Vec<[f64; 6]> = (0..2000)
        .map(|_| {
            let x = random.direction() * random.log(6.0, 20.0);
            let v = (random.direction() * random.log(0.1, 1.0) - x.normalize()).normalize();
            [x.x, x.y, x.z, v.x, v.y, v.z]
        })
        .collect();
    let ball =
        "[materials.a]\n[[objects]]\nshape = \"sphere\"\ncenter = [1.5, -3, 1]\nradius = 0.8\nmaterial = \"a\"\n";
    for (bound, objects, length) in [("[3, -2, 1]", "", 30.0), ("[0, 0, 0]", ball, 25.0), ("[0, 0, 0]", "", 25.0)] {
        let ends = ["method = \"separated\"\nscaled_step = 0.03", "method = \"dormand-prince\"\ntolerance = 1e-7"].map(|method| {
            let scene = scene(&format!(
                "[law]\nkind = \"kerr-newman\"\nspin = 0.9\naxis = [1, 2, 2]\n[rays]\n{method}\nmax_segments = 20000\n\
                 bounding_sphere = {{ center = {bound}, radius = {length} }}\n{objects}"
            ));
            trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap().0
        });
        let [own, general] = &ends;
        let [mut most, mut off, mut hits] = [0.0_f64, 0.0, 0.0];
        for (a, b) in own.iter().zip(general) {
            assert_eq!(a.status, b.status, "{a:?} {b:?} in {bound} with {objects}");
            hits += f64::from(u8::from(a.status == Status::Hit));
            // The approach of a captured ray to the horizon depends on the steps of its method.
            if a.status != Status::Captured {
                let way = DVec3::from(a.v).normalize().distance(DVec3::from(b.v).normalize());
                let place = DVec3::from(a.x).distance(DVec3::from(b.x)) / length;
                let time = (a.tau - b.tau).abs() / length;
                let apart = way.max(place).max(time);
                most = most.max(apart);
                off += f64::from(u8::from(apart > 2e-4));
            }
        }
        println!("bound {bound}: {hits} hit, {off} are apart, {most:e} at most");
        assert!(
            off <= 0.01 * rays.len() as f64 && most < 0.01,
            "{off} apart, {most} at most, in {bound} with {objects}"
        );
        assert_eq!(hits > 20.0, !objects.is_empty(), "{hits} hit");
    }
}

/// Without objects one segment skips many steps. Paths to be drawn are arcs throughout, also if frame dragging turns them
/// near a horizon, and they end like their rays.
#[test]
fn paths_to_be_drawn_are_arcs() {
    let gpu = gpu();
    let mut random = Random::new(91);
    let rays: Vec<[f64; 6]> = (0..200)
        .map(|_| {
            let x = 12.0 * random.direction();
            let v = (0.6 * random.direction() - x.normalize()).normalize();
            [x.x, x.y, x.z, v.x, v.y, v.z]
        })
        .collect();
    for law in [
        "kind = \"schwarzschild\"\n[rays]\nmethod = \"planar\"",
        "kind = \"kerr-newman\"\nspin = 0.95\n[rays]\nmethod = \"separated\"",
    ] {
        let scene = scene(&format!("[law]\n{law}\nscaled_step = 0.1\nbounding_sphere = {{ radius = 25 }}\n"));
        let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
        let paths = trace_paths(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
        for (end, (status, path)) in ends.iter().zip(&paths) {
            assert_eq!(end.status, *status);
            let way = |point: &PathPoint| DVec3::from(point.v).normalize();
            let turn = path.windows(2).map(|pair| way(&pair[0]).angle_between(way(&pair[1]))).fold(0.0, f64::max);
            assert!(path.len() > 5 && turn < 0.5, "{law}: {turn} rad in one of {} arcs", path.len());
            let last = path.last().unwrap();
            if end.status == Status::Escaped {
                let off = DVec3::from(end.x).distance(DVec3::from(last.x)) / 25.0;
                assert!(off < 2e-3, "{law}: off by {off} from {end:?}");
            }
        }
        assert!(ends.iter().any(|end| end.status == Status::Captured), "{law}");
    }
}
