//! Tests the ends of rays around black holes with spin and charge: shadows and their edges, and no wrong result without a
//! warning.

use bentray::model::camera::observer;
use bentray::model::law::KerrNewman;
use bentray::model::point_source::spheroid;
use bentray::model::{Camera, Law, Value};
use bentray::render::{RenderSettings, Status, trace};
use glam::DVec3;

use crate::oracle::{rows, traced, vector};
use crate::shaders::Random;
use crate::spacetimes::typed;
use crate::support::{gpu, scene};

/// Rays on either side of the edge of a shadow, 2e-3 rad from it and with no object near the black hole: light that reaches
/// the spherical photon orbit from outside is captured.
#[test]
fn shadows_end_where_spherical_orbits_of_light_say() {
    let rows = rows(include_str!("tables/kerr_shadows.tsv"));
    let gpu = gpu();
    let scene_of =
        |row: &[&str]| format!("[law]\n{}\nmax_segments = 20000\nbounding_sphere = {{ radius = 60 }}\n", row[1]);
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

/// Returns the ray that a distant camera at this inclination would see at the height β and α to the side, traced from 30 M.
/// The light has L/E = ξ = −α sin i and Carter's Q/E² = η, which Newton's method solves for.
fn light_seen_at(hole: &KerrNewman, inclination: f64, [alpha, beta]: [f64; 2]) -> [f64; 6] {
    let (sin, cos) = inclination.to_radians().sin_cos();
    let (side, up) = (DVec3::Y, DVec3::new(-cos, 0.0, sin));
    let x = 30.0 * DVec3::new(sin, 0.0, cos);
    let velocity = |p: [f64; 2]| hole.starting_velocity(x, (p[0] * side + p[1] * up - x).normalize());
    let (xi, a2) = (-alpha * sin, hole.spin * hole.spin);
    let eta = beta * beta + cos * cos * (alpha * alpha - a2);
    let off = |p: [f64; 2]| match &hole.invariants(x, velocity(p))[..] {
        [_, momentum, carter] => [momentum.value - xi, carter.value - eta],
        _ => panic!("no energy at {x}"),
    };
    let mut p = [alpha, beta];
    for _ in 0..20 {
        let (here, step) = (off(p), 1e-6);
        let by = |there: [f64; 2]| {
            off(there).iter().zip(here).map(|(there, here)| (there - here) / step).collect::<Vec<_>>()
        };
        let (first, second) = (by([p[0] + step, p[1]]), by([p[0], p[1] + step]));
        // In the equatorial plane nothing depends on a small height.
        if beta == 0.0 {
            p[0] -= here[0] / first[0];
        } else {
            let area = first[0] * second[1] - first[1] * second[0];
            p[0] -= (here[0] * second[1] - here[1] * second[0]) / area;
            p[1] -= (here[1] * first[0] - here[0] * first[1]) / area;
        }
    }
    let [momentum, carter] = off(p);
    assert!(
        momentum.abs().max(carter.abs()) < 1e-8,
        "L is off by {momentum}, Q by {carter} for {alpha} {beta} at {inclination}"
    );
    let v = velocity(p);
    [x.x, x.y, x.z, v.x, v.y, v.z]
}

/// Critical curves as seen from infinity: a ray 10⁻⁴ M further in is captured, and one 10⁻⁴ M further out escapes.
#[test]
fn critical_curves_are_where_closed_forms_say() {
    let gpu = gpu();
    for row in rows(include_str!("tables/critical_curves.tsv")) {
        let law = row[1].replace(';', "\n");
        let given = |key: &str| law.lines().find_map(|line| line.strip_prefix(key)?.parse().ok()).unwrap_or(0.0);
        let (spin, charge) = (given("spin="), given("charge="));
        let hole = KerrNewman { mass: 1.0, spin, axis: DVec3::Z, charge, center: DVec3::ZERO };
        let inclination: f64 = row[2].parse().unwrap();
        let points = row[3].split("; ").map(|point| point.split(' ').map(|n| n.parse().unwrap()).collect::<Vec<f64>>());
        // The end points of a curve off the equator turn at the pole of their sphere; the other points represent them.
        let points: Vec<_> = points.filter(|point| inclination > 89.0 || point[1] > 0.0).collect();
        let middle = 0.5 * (points[0][0] + points.last().unwrap()[0]);
        let rays = points.iter().flat_map(|point| {
            let out = 1e-4 / (point[0] - middle).hypot(point[1]);
            [1.0 - out, 1.0 + out].map(|k| [middle + k * (point[0] - middle), k * point[1]])
        });
        let rays: Vec<_> = rays.map(|seen| light_seen_at(&hole, inclination, seen)).collect();
        let base = "[rays]\nbounding_sphere = { radius = 60 }\nmax_segments = 20000\n";
        let mut laws = vec![
            format!("[law]\n{law}\n{base}method = \"separated\"\n"),
            format!("[law]\n{law}\n{base}method = \"dormand-prince\"\ntolerance = 1e-6\n"),
        ];
        if spin == 0.0 {
            laws.push(format!("[law]\nkind = \"reissner-nordstrom\"\ncharge = {charge}\n{base}method = \"planar\"\n"));
        }
        for text in laws {
            let (ends, _) = trace(&gpu, &scene(&text), &RenderSettings::default(), &rays).unwrap();
            for (pair, point) in ends.chunks(2).zip(&points) {
                let fates = [pair[0].status, pair[1].status];
                assert_eq!(fates, [Status::Captured, Status::Escaped], "{} at {point:?} by {text}", row[0]);
            }
        }
    }
}

/// Returns the status of light by its radial potential R = (r² + a² − aξ)² − Δ(η + (ξ−a)²). Inward light is captured if R has no
/// root on its path, outward light escapes if R has none there, and light without positive energy comes from the black hole. Returns
/// `None` within 10⁻⁴ of the critical curve, which is about 5 M wide: R over twice its slope by ξ and √η is the distance from it.
pub fn fate(hole: &KerrNewman, x: DVec3, v: DVec3) -> Option<Status> {
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
    let end = if is_outwards { 1e6 } else { horizon };
    let least =
        (0..=4000).map(|i| potential(here * (end / here).powf(f64::from(i) / 4000.0))).fold(f64::INFINITY, f64::min);
    let through = if is_outwards { Status::Escaped } else { Status::Captured };
    let back = if is_outwards { Status::Captured } else { Status::Escaped };
    (least.abs() > 5e-4 * hole.mass).then_some(if least > 0.0 { through } else { back })
}

/// Returns the velocity of the light that a camera sees from a direction of the scene.
fn seen_light(law: &dyn Law, camera: &Camera, d: DVec3) -> DVec3 {
    let fed = observer(law, camera).unwrap();
    let column = |name: &str| match fed.iter().find(|(member, _)| member == name) {
        Some((_, Value::Vec4(v))) => *v,
        _ => panic!("no {name}"),
    };
    let light = column("rest") + d.x * column("x") + d.y * column("y") + d.z * column("z");
    light.truncate() / -light.w
}

/// In an ergosphere some of the visible light would have negative energy far away, and can only come from the horizon.
#[test]
fn light_without_energy_comes_from_the_horizon() {
    let rows = rows(include_str!("tables/kerr_ergosphere.tsv"));
    let base = "[camera]\nposition = [1.3, 0.9, 0.2]\nlook_at = [0.3, 0.9, 0.2]\nup = [0, 0, 1]\nobserver = \"zamo\"\n\
                [law]\nkind = \"kerr-newman\"\nspin = 0.998\n[rays]\nbounding_sphere = { radius = 60 }\nmax_segments = 20000\n";
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

/// Returns `true` if no light, or light from below r₊, arrives along this inward ray: the least radial potential R = (r² + a² − aξ)² − Δχ
/// between it and the horizon is positive. R = 0 is a spherical photon orbit, on the closed curve of the shadow.
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

/// The edges of shadows at 100 points each for seven observers: rays 10⁻⁵ rad further in are captured, and 10⁻⁵ rad further out escape,
/// also with photon orbits very close to the horizon. At the greatest spin they are at it, and the edge is known to 10⁻⁴ rad.
#[test]
fn shadows_have_sharp_edges_where_closed_curves_say() {
    let gpu = gpu();
    for (spin, charge, at, frame) in [
        (0.5, 0.0, [0.0, -19.7, 3.5], "static"),
        (0.9, 0.0, [19.7, 0.0, 3.5], "static"),
        (0.998, 0.0, [5.0, 5.0, 4.0], "zamo"),
        (0.95, 0.0, [0.0, 9.0, -1.0], "infalling"),
        (0.6, 0.6, [2.0, -7.0, 0.0], "static"),
        (0.9995, 0.0, [0.0, -12.0, 2.0], "static"),
        (1.0, 0.0, [3.0, 19.0, 4.0], "static"),
    ] {
        let hole = KerrNewman { mass: 1.0, spin, axis: DVec3::Z, charge, center: DVec3::ZERO };
        let x = DVec3::from_array(at);
        let base = format!(
            "[camera]\nposition = {at:?}\nlook_at = [0, 0, 0]\nup = [0, 0, 1]\nobserver = \"{frame}\"\n\
             [law]\nkind = \"kerr-newman\"\nspin = {spin}\ncharge = {charge}\n[rays]\nbounding_sphere = {{ radius = 60 }}\nmax_segments = 20000\n"
        );
        let seen = scene(&base);
        let camera = seen.camera.as_ref().unwrap();
        let velocity = |d: DVec3| seen_light(&hole, camera, d);
        let beside = if spin < 1.0 { 1e-5 } else { 1e-4 };
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
            rays.extend([dark - beside, bright + beside].map(|angle| {
                let v = towards(angle);
                [x.x, x.y, x.z, v.x, v.y, v.z]
            }));
        }
        // Near the greatest spin light stays near the horizon for so long that general methods need 64 bits.
        let general = if spin < 0.9987 {
            "method = \"dormand-prince\"\ntolerance = 1e-7"
        } else {
            "method = \"dormand-prince\"\ntolerance = 1e-11\nprecision = \"f64\""
        };
        for method in ["method = \"separated\"\nscaled_step = 0.05", general] {
            let (ends, _) =
                trace(&gpu, &scene(&format!("{base}{method}\n")), &RenderSettings::default(), &rays).unwrap();
            for (i, pair) in ends.chunks(2).enumerate() {
                // At the greatest spin light may stay near the horizon beyond the limit of segments.
                let is_right = |found: Status, told: Status| found == told || spin >= 1.0 && found == Status::Exhausted;
                let [dark, bright] = [pair[0].status, pair[1].status];
                let right = is_right(dark, Status::Captured) && is_right(bright, Status::Escaped);
                assert!(right, "{spin} {frame} {method}: point {i} is {dark:?} inside and {bright:?} outside");
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
        // Just above the horizon light takes forever; below it, light escapes or has come from below.
        let far = horizon + 0.05;
        let near = hole.inner_horizon().unwrap() + 0.1..horizon - 0.05;
        let (mut rays, mut fates) = (Vec::new(), Vec::new());
        while rays.len() < 4_000 {
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
                "[law]\nkind = \"kerr-newman\"\nspin = {spin}\ncharge = {charge}\n[rays]\nbounding_sphere = {{ radius = 1001 }}\n\
                 max_segments = 20000\nmethod = \"{method}\"\n"
            ));
            let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
            // At the greatest spin light near ξ = 2 stays near the horizon for thousands of M, and general methods in 32 bits lose it.
            let is_told = |ray: &[f64; 6]| {
                let [x, v] = [0, 3].map(|i| DVec3::from_slice(&ray[i..]));
                let kept = hole.invariants(x, hole.starting_velocity(x, v));
                spin < 1.0 || method == "separated" || kept.get(1).is_none_or(|own| (own.value - 2.0).abs() > 0.03)
            };
            let told = ends.iter().zip(&fates).zip(&rays).filter(|(_, ray)| is_told(ray));
            let wrong: Vec<_> = told.filter(|((end, fate), _)| end.status != **fate).collect();
            let flagged = |s: Status| !matches!(s, Status::Escaped | Status::Captured);
            let silent = wrong.iter().filter(|((end, _), _)| !flagged(end.status)).count();
            println!("{spin} {charge} {method}: {} wrong, {silent} in silence; {:?}", wrong.len(), wrong.first());
            assert_eq!(silent, 0, "a = {spin}, Q = {charge}, {method}");
        }
    }
}
