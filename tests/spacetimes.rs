//! Light round holes with spin and charge, against answers to 15 digits and against what must be so.

use bentray::assets::Transform;
use bentray::measure::drift;
use bentray::model::camera::observer;
use bentray::model::law::{ChargedHole, KerrNewman};
use bentray::model::source::spheroid;
use bentray::model::{Camera, Law, Value};
use bentray::render::{RenderSettings, Status, trace};
use glam::{DVec3, DVec4};

use crate::oracle::{rows, traced, vector};
use crate::shaders::Random;
use crate::support::{gpu, scene};

/// The law of a table's row, `kind="kerr-newman";spin=0.9`, as a user would type it.
pub fn typed(law: &str) -> String {
    let given = |key: &str| {
        law.split(';').find_map(|pair| pair.strip_prefix(key)?.strip_prefix('=')).map_or(0.0, |n| n.parse().unwrap())
    };
    let (a, charge): (f64, f64) = (given("spin"), given("charge"));
    // Into the past light nears a horizon for ever.
    let horizon = (1.0 - a * a - charge * charge).max(0.0).sqrt() + 1.01;
    format!(
        "kind = \"metric\"\nline_element = \"-dt^2 + dx^2 + dy^2 + dz^2 + f*l^2\"\nscale = \"R\"\ncaptured = \"R < horizon\"\n\
         parameters = {{ a = {a}, Q = {charge}, horizon = {horizon} }}\n\
         terms = {{ k = \"(r^2 - a^2)/2\", d = \"sqrt(k^2 + a^2*z^2)\", R = \"sqrt(k + d)\", f = \"(2*R - Q^2)/(2*d)\", \
         l = \"dt + ((R*x + a*y)*dx + (R*y - a*x)*dy)/(R^2 + a^2) + z*dz/R\" }}"
    )
}

/// As other tables: in 32 bits within 2e-5 or 40 times what one rounding of the input does, in 64 within 1e-9; also about a hole that
/// stands elsewhere and spins about another axis, and by its line element. What is kept along a ray is kept as well as its end is known.
#[test]
fn rays_round_spinning_holes_end_where_series_say() {
    let rows = rows(include_str!("tables/kerr_newman.tsv"));
    let gpu = gpu();
    let (there, degrees) = (DVec3::new(0.5, -0.25, 0.125), DVec3::new(30.0, -50.0, 70.0));
    let places = [(DVec3::ZERO, DVec3::ZERO), (degrees, there)];
    let ways = [
        (false, "f32", "method = \"dormand-prince\"\ntolerance = 1e-6"),
        (true, "f32", "method = \"dormand-prince\"\ntolerance = 1e-6"),
        (false, "f32", "method = \"separated\"\nscaled_step = 0.02"),
        (false, "f64", "method = \"dormand-prince\"\ntolerance = 1e-13"),
        (true, "f64", "method = \"dormand-prince\"\ntolerance = 1e-13"),
        (false, "f64", "method = \"separated\"\nscaled_step = 0.003"),
    ];
    for (degrees, shift) in places {
        let turn = Transform::new(DVec3::ONE, degrees, DVec3::ZERO).0.matrix3;
        for (is_typed, precision, method) in ways {
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
                     bound = {{ center = {center:?}, radius = {} }}\n",
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
                    ("time", (end.tau - number(8)).abs() / radius, factor * number(9) / radius),
                ];
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
}

/// A hole without spin and charge is Schwarzschild's, of which these coordinates have the places and the paths.
#[test]
fn without_spin_and_charge_it_is_schwarzschilds() {
    let all = rows(include_str!("tables/ends.tsv"));
    let rows: Vec<_> =
        all.into_iter().filter(|row| row[1].contains("schwarzschild\"") && row[1].contains("\"path\"")).collect();
    assert!(rows.len() >= 5, "{}", rows.len());
    let scene_of = |row: &[&str]| {
        let law = row[1].replace("schwarzschild", "kerr-newman").replace(";form=\"path\"", "").replace(';', "\n");
        format!(
            "[law]\n{law}\n[rays]\nmethod = \"dormand-prince\"\ntolerance = 1e-12\nprecision = \"f64\"\nmax_segments = 20000\n\
             bound = {{ radius = {} }}\n",
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

/// Rays on either side of the edge of a shadow, 2e-3 rad from it, with nothing near the hole: what is taken in at the orbit of light
/// is what never comes back.
#[test]
fn shadows_end_where_spherical_orbits_of_light_say() {
    let rows = rows(include_str!("tables/kerr_shadows.tsv"));
    let gpu = gpu();
    let scene_of = |row: &[&str]| format!("[law]\n{}\nmax_segments = 20000\nbound = {{ radius = 60 }}\n", row[1]);
    let by = |method: &str| format!("\n[rays]\nmethod = \"{method}\"");
    let general = by("dormand-prince") + "\ntolerance = 1e-6";
    let laws = |law: &str| {
        let own = law.replace(';', "\n");
        [own.clone() + &general, own + &by("separated"), typed(law) + &general]
    };
    for (column, fate, kind) in [(3, "captured"), (4, "escaped")]
        .into_iter()
        .flat_map(|(column, fate)| (0..3).map(move |kind| (column, fate, kind)))
    {
        for row in &rows {
            let directions: Vec<&str> = row[column].split("; ").collect();
            let law = &laws(row[1])[kind];
            let rays: Vec<Vec<&str>> = directions.iter().map(|way| vec![row[0], law, row[2], *way]).collect();
            let ends = traced(&gpu, &rays, scene_of, |ray| (vector(ray[2]), vector(ray[3])));
            assert!(ends.len() >= 16);
            for (ray, end) in rays.iter().zip(ends) {
                assert_eq!(end.status.name(), fate, "{} towards {}", ray[0], ray[3]);
            }
        }
    }
}

/// What an observer sees as right, up and forward; and the light that it sees goes into the past, null and as fast as `law_start` has it.
#[test]
fn observers_have_the_axes_of_their_four_velocities() {
    let four = |text: &str| DVec4::from_slice(&text.split(' ').map(|n| n.parse().unwrap()).collect::<Vec<f64>>());
    let rows = rows(include_str!("tables/kerr_frames.tsv"));
    let laws = rows.iter().flat_map(|row| [row[1].replace(';', "\n"), typed(row[1])].map(|law| (row, law)));
    for (row, law) in laws.filter(|(row, law)| row[3] != "falling" || !law.contains("metric")) {
        let (position, forward) = (vector(row[2]), vector(row[4]));
        let up = vector(row[5]).to_array();
        let camera = format!(
            "[camera]\nposition = {:?}\nlook_at = {:?}\nup = {up:?}\nframe = \"{}\"\n",
            position.to_array(),
            (position + forward).to_array(),
            row[3]
        );
        let velocity = row.get(10).map_or(String::new(), |v| format!("velocity = {:?}\n", vector(v).to_array()));
        let scene = scene(&format!("{camera}{velocity}[law]\n{law}\n[rays]\nbound = {{ radius = 60 }}\n"));
        let camera = scene.camera.as_ref().unwrap();
        let fed = observer(&*scene.law, camera).unwrap();
        let column = |name: &str| match fed.iter().find(|(member, _)| member == name) {
            Some((_, Value::Vec4(v))) => *v,
            _ => panic!("no {name}"),
        };
        // A line element's circular orbits are by differences.
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
            assert!(light.w < 0.0 && settled.distance(v) < 10.0 * bound, "{}: {light} is no light of the past", row[0]);
        }
    }
}

/// What becomes of light by its radial potential R = (r² + a² − aξ)² − Δ(η + (ξ−a)²): what moves inwards falls in if R has no root on
/// its way, what moves outwards escapes if it has none there, and what has no energy left comes from the hole. None within 10⁻⁴ of the
/// critical curve, which is some 5 M wide: R over twice its slope by ξ and √η says how far off that is.
fn fate(hole: &KerrNewman, x: DVec3, v: DVec3) -> Option<Status> {
    let (kept, here) = (hole.invariants(x, v), hole.at(x).r);
    let [_, momentum, carter] = kept[..] else { return Some(Status::Captured) };
    let (a2, horizon) = (hole.spin * hole.spin, hole.horizon().unwrap());
    let chi = carter.value + (momentum.value - hole.spin).powi(2);
    let potential = |r: f64| {
        let first = r * r + a2 - hole.spin * momentum.value;
        let delta = r * r - 2.0 * hole.mass * r + a2 + hole.charge * hole.charge;
        let slope =
            hole.spin * first.abs() + delta.abs() * (carter.value.max(0.0).sqrt() + (momentum.value - hole.spin).abs());
        (first * first - delta * chi) / (2.0 * slope)
    };
    // Light from below the horizon.
    let leaving = horizon * horizon + a2 - hole.spin * momentum.value;
    if here < horizon {
        let crosses = (leaving.abs() > 1e-2).then_some(leaving > 0.0)?;
        if !crosses {
            return Some(Status::Captured);
        }
    }
    let is_outwards = spheroid::of(x - hole.center, hole.spin * hole.axis).1.dot(v) > 0.0;
    let end = if is_outwards { 1e6 } else { horizon + 0.01 * hole.mass };
    let least =
        (0..=4000).map(|i| potential(here * (end / here).powf(f64::from(i) / 4000.0))).fold(f64::INFINITY, f64::min);
    let through = if is_outwards { Status::Escaped } else { Status::Captured };
    let back = if is_outwards { Status::Captured } else { Status::Escaped };
    (least.abs() > 5e-4 * hole.mass).then_some(if least > 0.0 { through } else { back })
}

/// The velocity of the light that a camera sees from a direction of the scene.
fn seen_light(law: &dyn Law, camera: &Camera, d: DVec3) -> DVec3 {
    let fed = observer(law, camera).unwrap();
    let column = |name: &str| match fed.iter().find(|(member, _)| member == name) {
        Some((_, Value::Vec4(v))) => *v,
        _ => panic!("no {name}"),
    };
    let light = column("rest") + d.x * column("x") + d.y * column("y") + d.z * column("z");
    light.truncate() / -light.w
}

/// In an ergosphere some of the light that is seen has no energy left far away: it can only come from the horizon.
#[test]
fn light_without_energy_comes_from_the_horizon() {
    let rows = rows(include_str!("tables/kerr_ergosphere.tsv"));
    let base = "[camera]\nposition = [1.3, 0.9, 0.2]\nlook_at = [0.3, 0.9, 0.2]\nup = [0, 0, 1]\nframe = \"zamo\"\n\
                [law]\nkind = \"kerr-newman\"\nspin = 0.998\n[rays]\nbound = { radius = 60 }\nmax_segments = 20000\n";
    let seen = scene(base);
    let camera = seen.camera.as_ref().unwrap();
    let x = camera.position;
    let rays = rows.iter().map(|row| {
        let d = vector(row[0]).normalize();
        let v = seen_light(&*seen.law, camera, d.x * camera.right + d.y * camera.up + d.z * camera.forward);
        [x.x, x.y, x.z, v.x, v.y, v.z]
    });
    let rays: Vec<_> = rays.collect();
    for method in ["separated", "dormand-prince", "rk4"] {
        let scene = scene(&format!("{base}method = \"{method}\"\n"));
        let (ends, _) = trace(&gpu(), &scene, &RenderSettings::default(), &rays).unwrap();
        for (row, end) in rows.iter().zip(ends) {
            assert_eq!(end.status.name(), row[2], "{method}: {}, of energy {}", row[0], row[1]);
        }
    }
}

/// Does light from below r₊, or none, come along this inward ray? The least value of its radial potential R = (r² + a² − aξ)² − Δχ between
/// it and the horizon is above 0: where that is 0 a spherical orbit of light is, and the closed curve of the shadow.
fn is_dark(hole: &KerrNewman, x: DVec3, v: DVec3) -> bool {
    let (kept, here) = (hole.invariants(x, v), hole.at(x).r);
    let [_, momentum, carter] = kept[..] else { return true };
    let (a2, horizon) = (hole.spin * hole.spin, hole.horizon().unwrap());
    let chi = carter.value + (momentum.value - hole.spin).powi(2);
    let (shift, own) = (a2 - hole.spin * momentum.value, a2 + hole.charge * hole.charge);
    let potential = |r: f64| (r * r + shift).powi(2) - (r * r - 2.0 * hole.mass * r + own) * chi;
    let least = (0..=400).map(|i| here * (horizon / here).powf(f64::from(i) / 400.0));
    let mut least = least.min_by(|a, b| potential(*a).total_cmp(&potential(*b))).unwrap();
    for _ in 0..20 {
        let slope = 4.0 * least * (least * least + shift) - 2.0 * (least - hole.mass) * chi;
        let bend = 12.0 * least * least + 4.0 * shift - 2.0 * chi;
        let next = least - slope / bend;
        least = if bend > 0.0 && next > horizon && next < here { next } else { least };
    }
    potential(least) > 0.0
}

/// The edges of shadows at 100 points each for five observers: 10⁻⁵ rad further in is dark, and 10⁻⁵ further out is sky. From a = 0.9987 on the
/// orbit of light is so near to the horizon that the edge is off by more there.
#[test]
fn shadows_have_sharp_edges_where_closed_curves_say() {
    let gpu = gpu();
    for (spin, charge, at, frame) in [
        (0.5, 0.0, [0.0, -19.7, 3.5], "static"),
        (0.9, 0.0, [19.7, 0.0, 3.5], "static"),
        (0.998, 0.0, [5.0, 5.0, 4.0], "zamo"),
        (0.95, 0.0, [0.0, 9.0, -1.0], "falling"),
        (0.6, 0.6, [2.0, -7.0, 0.0], "static"),
    ] {
        let hole = KerrNewman { mass: 1.0, spin, axis: DVec3::Z, charge, center: DVec3::ZERO };
        let x = DVec3::from_array(at);
        let base = format!(
            "[camera]\nposition = {at:?}\nlook_at = [0, 0, 0]\nup = [0, 0, 1]\nframe = \"{frame}\"\n\
             [law]\nkind = \"kerr-newman\"\nspin = {spin}\ncharge = {charge}\n[rays]\nbound = {{ radius = 60 }}\nmax_segments = 20000\n"
        );
        let seen = scene(&base);
        let camera = seen.camera.as_ref().unwrap();
        let velocity = |d: DVec3| seen_light(&hole, camera, d);
        let mut rays = Vec::new();
        for point in 0..100 {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(point) / 100.0).sin_cos();
            let aside = cos * camera.right + sin * camera.up;
            let towards = |angle: f64| velocity(angle.cos() * camera.forward + angle.sin() * aside);
            let (mut dark, mut bright) = (0.0, 1.4);
            assert!(is_dark(&hole, x, towards(dark)) && !is_dark(&hole, x, towards(bright)), "{spin} {frame}");
            for _ in 0..60 {
                let middle = 0.5 * (dark + bright);
                *(if is_dark(&hole, x, towards(middle)) { &mut dark } else { &mut bright }) = middle;
            }
            rays.extend([dark - 1e-5, bright + 1e-5].map(|angle| {
                let v = towards(angle);
                [x.x, x.y, x.z, v.x, v.y, v.z]
            }));
        }
        for method in ["method = \"separated\"\nscaled_step = 0.05", "method = \"dormand-prince\"\ntolerance = 1e-7"] {
            let (ends, _) =
                trace(&gpu, &scene(&format!("{base}{method}\n")), &RenderSettings::default(), &rays).unwrap();
            for (i, pair) in ends.chunks(2).enumerate() {
                let fates = [pair[0].status, pair[1].status];
                assert_eq!(fates, [Status::Captured, Status::Escaped], "{spin} {frame} {method}: point {i}");
            }
        }
    }
}

#[test]
fn every_fate_is_right_round_spinning_holes() {
    let gpu = gpu();
    let mut random = Random::new(82);
    for (spin, charge) in [(0.0, 0.0), (0.5, 0.0), (0.9, 0.0), (0.998, 0.0), (1.0, 0.0), (0.6, 0.6)] {
        let hole = KerrNewman { mass: 1.0, spin, axis: DVec3::Z, charge, center: DVec3::ZERO };
        let horizon = hole.horizon().unwrap();
        // Just above the horizon light takes for ever; below it, it leaves or has come from below.
        let far = horizon + 0.05;
        let near = hole.inner_horizon().unwrap() + 0.1..horizon - 0.05;
        let (mut rays, mut fates) = (Vec::new(), Vec::new());
        while rays.len() < 10_000 {
            let x = random.direction() * random.log(0.1, 1000.0);
            let aimed = -x.normalize() + random.direction() * random.log(1e-3, 1.0);
            let d = if random.unit() < 0.7 { aimed.normalize() } else { random.direction() };
            let v = hole.starting_velocity(x, d);
            let r = hole.at(x).r;
            if r < far && !near.contains(&r) || !v.is_finite() {
                continue;
            }
            if let Some(fate) = fate(&hole, x, v) {
                rays.push([x.x, x.y, x.z, v.x, v.y, v.z]);
                fates.push(fate);
            }
        }
        for method in ["rk4", "dormand-prince", "bogacki-shampine", "separated"] {
            let scene = scene(&format!(
                "[law]\nkind = \"kerr-newman\"\nspin = {spin}\ncharge = {charge}\n[rays]\nbound = {{ radius = 1001 }}\n\
                 max_segments = 20000\nmethod = \"{method}\"\n"
            ));
            let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
            let wrong: Vec<_> =
                ends.iter().zip(&fates).zip(&rays).filter(|((end, fate), _)| end.status != **fate).collect();
            let flagged = |s: Status| !matches!(s, Status::Escaped | Status::Captured);
            let silent = wrong.iter().filter(|((end, _), _)| !flagged(end.status)).count();
            println!("{spin} {charge} {method}: {} wrong, {silent} in silence; {:?}", wrong.len(), wrong.first());
            assert_eq!(silent, 0, "a = {spin}, Q = {charge}, {method}");
        }
    }
}

/// As round holes: line elements as a user writes them, with and without t, also turned and elsewhere.
#[test]
fn rays_by_line_elements_end_where_series_say() {
    let rows = rows(include_str!("tables/line_elements.tsv"));
    let gpu = gpu();
    for (precision, tolerance, floor, factor) in [("f32", 1e-6, 2e-5_f64, 40.0), ("f64", 1e-12, 1e-9, 0.0)] {
        for (degrees, shift) in
            [(DVec3::ZERO, DVec3::ZERO), (DVec3::new(30.0, -50.0, 70.0), DVec3::new(0.5, -0.25, 0.125))]
        {
            let turn = Transform::new(DVec3::ONE, degrees, DVec3::ZERO).0.matrix3;
            let scene_of = |row: &[&str]| {
                format!(
                    "[law]\n{}\ncenter = {:?}\nrotate = {:?}\n[rays]\nmethod = \"dormand-prince\"\ntolerance = {tolerance}\n\
                     precision = \"{precision}\"\nmax_segments = 20000\n{}\n",
                    row[1].replace(';', "\n"),
                    shift.to_array(),
                    degrees.to_array(),
                    row[2]
                        .replace(';', "\n")
                        .replace("{radius", &format!("{{ center = {:?}, radius", shift.to_array())),
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
}

/// Where a line element has no derivative, or no space at one time, a ray fails; it never ends as something else.
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
                "[law]\nkind = \"metric\"\nline_element = \"{element}\"\nscale = \"3\"\n[rays]\nbound = {{ radius = 9 }}\n\
                 method = \"{method}\"\n"
            ));
            let ray = [x.x, x.y, x.z, v.x, v.y, v.z];
            let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &[ray]).unwrap();
            assert_eq!(ends[0].status, fate, "{element} by {method}");
        }
    }
}

/// Without spin the hole of Kerr and Newman is Reissner's and Nordström's: the same paths in the same places, also under `planar` and with a
/// cosmological constant.
#[test]
fn charged_holes_are_those_of_kerr_and_newman_without_spin() {
    let gpu = gpu();
    let mut random = Random::new(83);
    for charge in [0.0, 0.6, 1.0] {
        let hole = KerrNewman { mass: 1.0, spin: 0.0, axis: DVec3::Z, charge, center: DVec3::ZERO };
        let (mut rays, mut fates) = (Vec::new(), Vec::new());
        while rays.len() < 2000 {
            let x = random.direction() * random.log(4.0, 20.0);
            let v = (random.direction() - 0.7 * x.normalize()).normalize();
            if let Some(fate) = fate(&hole, x, hole.starting_velocity(x, v)) {
                rays.push([x.x, x.y, x.z, v.x, v.y, v.z]);
                fates.push(fate);
            }
        }
        let ends_by = |law: &str, rays_table: &str| {
            let scene = scene(&format!(
                "[law]\n{law}\n[rays]\nbound = {{ radius = 30 }}\nmax_segments = 20000\nprecision = \"f64\"\n{rays_table}"
            ));
            trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap().0
        };
        let fine = "method = \"dormand-prince\"\ntolerance = 1e-12";
        let spinless = ends_by(&format!("kind = \"kerr-newman\"\ncharge = {charge}"), fine);
        let charged = format!("kind = \"reissner-nordstrom\"\ncharge = {charge}");
        let vast = format!("{charged}\ncosmological = 0.01");
        for (law, method, bound) in
            [(&charged, fine, 1e-8), (&vast, fine, 1e-8), (&charged, "method = \"planar\"\nscaled_step = 0.005", 1e-7)]
        {
            let ends = ends_by(law, method);
            for (i, (end, other)) in ends.iter().zip(&spinless).enumerate() {
                assert_eq!(end.status, fates[i], "Q = {charge}, {method}: {:?}", rays[i]);
                assert_eq!(other.status, fates[i], "Q = {charge}: {:?}", rays[i]);
                if end.status == Status::Escaped {
                    let off = DVec3::from(end.x).distance(DVec3::from(other.x)) / 30.0;
                    // What winds about the hole errs by e^π more each half turn.
                    let bound = if other.steps > 200 { 1e3 * bound } else { bound };
                    assert!(off < bound, "Q = {charge}, {method}: off by {off:e}, {:?}", rays[i]);
                }
            }
        }
    }
}

/// Photon spheres, horizons and the least impact parameters of what gets away.
#[test]
fn charged_holes_have_their_landmarks() {
    for (charge, sphere, impact, horizon) in [
        (0.3, 2.938_749_456_993_815_7, 5.116_794_745_329_72, 1.953_939_201_416_945_7),
        (0.8, 2.484_885_780_179_610_5, 4.545_986_272_128_442, 1.6),
        (1.0, 2.0, 4.0, 1.0),
    ] {
        let hole = ChargedHole { mass: 1.0, charge, cosmological: 0.0, center: DVec3::ZERO };
        let found = hole.photon_sphere().unwrap();
        assert!((found - sphere).abs() < 1e-14 && (found / hole.clock(found).sqrt() - impact).abs() < 1e-14);
        assert!((hole.horizon().unwrap() - horizon).abs() < 1e-7, "{:?}", hole.horizon());
    }
    let vast = ChargedHole { mass: 1.0, charge: 0.0, cosmological: 0.1, center: DVec3::ZERO };
    let horizon = vast.horizon().unwrap();
    assert!(horizon > 2.0 && vast.clock(horizon).abs() < 1e-12 && vast.clock(3.0) > 0.0, "{horizon}");
}
