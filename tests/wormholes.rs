//! Light around wormholes and through them.

use bentray::measure::drift;
use bentray::model::law::Wormhole;
use bentray::render::{RenderSettings, Renderer, Status, trace};
use glam::DVec3;

use crate::oracle::{rows, traced, vector};
use crate::shaders::Random;
use crate::support::{gpu, scene};

/// Returns the line element of a wormhole as a user would write it, from the keys in a row.
fn written(law: &str) -> String {
    let number = |key: &str| {
        let found = law.split(';').find_map(|part| part.strip_prefix(key)?.strip_prefix('='));
        found.map(|text| text.parse::<f64>().unwrap())
    };
    let radius = number("radius").unwrap();
    let width = match number("mass") {
        None => "sqrt(rho0^2 + l^2)".to_owned(),
        Some(mass) => {
            let half = 0.5 * number("length").unwrap();
            let y = format!("max(2*(max(l, -l) - {half})/(pi*{mass}), 0)");
            format!("rho0 + {mass}*({y}*atan({y}) - log(1 + ({y})^2)/2)")
        }
    };
    let scale = number("mass").unwrap_or(radius);
    format!(
        "kind = \"metric\"\nthroat = {radius:?}\nparameters = {{ rho0 = {radius:?} }}\nline_element = \"-dt^2 + dl^2 + w^2*dOmega2\"\n\
         scale = \"min(r, max(l, -l) + {scale})\"\nterms = {{ w = \"{width}\" }}"
    )
}

/// Compares rays with a table: in 32 bits within 2e-5 or 40 times the effect of one rounding of the input, in 64 within 1e-9;
/// also for displaced mouths and written line elements. Speed and L/E are conserved on both sides, with the accuracy of the end.
#[test]
fn rays_end_on_the_side_and_where_quadratures_say() {
    let rows = rows(include_str!("tables/wormholes.tsv"));
    let gpu = gpu();
    let apart = 200.0 * DVec3::X;
    for (shift, is_written) in [(DVec3::ZERO, false), (DVec3::new(0.5, -0.25, 0.125), false), (DVec3::X, true)] {
        for (precision, tolerance, floor, factor) in [("f32", 1e-6, 2e-5_f64, 40.0), ("f64", 1e-13, 1e-9, 0.0)] {
            let scene_of = |row: &[&str]| {
                format!(
                    "[law]\n{}\ncenter = {:?}\nother_mouth = {:?}\n[rays]\nmethod = \"dormand-prince\"\ntolerance = {tolerance}\n\
                     precision = \"{precision}\"\nmax_segments = 20000\nbounding_sphere = {{ center = {:?}, radius = {} }}\n",
                    if is_written { written(row[1]) } else { row[1].replace(';', "\n") },
                    shift.to_array(),
                    (shift + apart).to_array(),
                    shift.to_array(),
                    row[2]
                )
            };
            let start = |row: &[&str]| (shift + vector(row[3]), vector(row[4]));
            for (row, end) in rows.iter().zip(traced(&gpu, &rows, scene_of, start)) {
                let number = |i: usize| row[i].parse::<f64>().unwrap();
                assert_eq!(end.status, Status::Escaped, "{} in {precision}", row[0]);
                let mouth = if number(5) > 0.0 { shift } else { shift + apart };
                let place = DVec3::from(end.x) - mouth;
                assert!((place.length() / number(2) - 1.0).abs() < 1e-5, "{}: on the wrong side", row[0]);
                let law = scene(&scene_of(row)).law;
                let (x, v) = start(row);
                let kept = drift(&*law, [([x, law.starting_velocity(x, v)], &end)].into_iter());
                // In units of proper length.
                let n = place.normalize();
                let (metric, v) = (law.metric(DVec3::from(end.x), 0.0).unwrap(), DVec3::from(end.v));
                let across = v - n.dot(v) * n;
                let wider = (metric * across.extend(0.0)).truncate().dot(across).sqrt() / across.length().max(1e-300);
                let direction = (n.dot(v) * n + wider * across).normalize();
                let mut errors = vec![
                    ("place", n.distance(vector(row[6])), factor * number(8)),
                    ("direction", direction.distance(vector(row[7])), factor * number(9)),
                ];
                errors.extend(kept.iter().map(|(name, drifted)| (*name, drifted.max, factor * number(9))));
                for (what, error, bound) in errors {
                    let bound = floor.max(bound);
                    println!("{} in {precision}: {what} {:.3} of the bound", row[0], error / bound);
                    assert!(error <= bound, "{} in {precision}: {what} off by {error:e}", row[0]);
                }
            }
        }
    }
}

/// Around an Ellis wormhole the angle from infinity to infinity is twice the complete elliptic integral K(ρ₀/b), and
/// through it (2b/ρ₀) K(b/ρ₀). From R it is less by b/R at each end.
#[test]
fn angles_round_ellis_wormhole_are_elliptic_integrals() {
    let far = 1e4;
    let gpu = gpu();
    for (radius, impact, passes, swept) in [
        (1.0, 2.0, false, 3.371_500_709_625_192),
        (1.0, 1.01, false, 6.722_916_240_265_279),
        (1.0, 0.5, true, 1.685_750_354_812_596),
        (2.5, 10.0, false, 3.192_484_444_263_567),
    ] {
        let law = Wormhole { radius, length: 0.0, mass: None, center: DVec3::ZERO, other: 3.0 * far * DVec3::X };
        let scene = scene(&format!(
            "[law]\nkind = \"wormhole\"\nradius = {radius}\nother_mouth = [{}, 0, 0]\n[rays]\nmethod = \"dormand-prince\"\ntolerance = 1e-13\n\
             precision = \"f64\"\nmax_segments = 20000\nbounding_sphere = {{ radius = {} }}\n",
            3.0 * far,
            far + radius
        ));
        // L/E = r v⊥, for unit speed.
        let sine = impact / law.width(far);
        let v = DVec3::new(-(1.0 - sine * sine).sqrt(), sine * (far + radius) / law.width(far), 0.0);
        let (ends, _) =
            trace(&gpu, &scene, &RenderSettings::default(), &[[far + radius, 0.0, 0.0, v.x, v.y, v.z]]).unwrap();
        let end = DVec3::from(ends[0].x);
        let is_through = end.distance(law.other) < end.length();
        assert_eq!(is_through, passes, "b = {impact}");
        let n = if is_through { end - law.other } else { end };
        let turned = n.y.atan2(n.x);
        let expected = swept - 2.0 * impact / far;
        let off = (turned - expected).rem_euclid(std::f64::consts::TAU);
        let off = off.min(std::f64::consts::TAU - off);
        assert!(off < 1e-9, "b = {impact}: {turned} for {expected}");
    }
}

/// A ray passes only if it is directed inward with b below the radius of the throat; no ray is within 1e-4 of that.
#[test]
fn every_ray_comes_out_on_the_right_side() {
    let gpu = gpu();
    let mut random = Random::new(84);
    for (length, mass) in [(0.0, None), (1.0, Some(0.3)), (0.01, Some(0.035))] {
        let law = Wormhole { radius: 1.0, length, mass, center: DVec3::ZERO, other: 300.0 * DVec3::X };
        let (mut rays, mut through) = (Vec::new(), Vec::new());
        while rays.len() < 4000 {
            let n = random.direction();
            let far = random.log(0.01, 100.0);
            let mouth = if random.unit() < 0.5 { law.center } else { law.other };
            let d = (random.direction() * random.log(1e-2, 1.0) - n).normalize();
            let rising = n.dot(d);
            let impact = (1.0 - rising * rising).sqrt() * law.width(far);
            if (impact - 1.0).abs() < 1e-4 {
                continue;
            }
            let (x, aside) = (mouth + (1.0 + far) * n, d - rising * n);
            // In scene coordinates.
            let v = rising * n + aside * ((1.0 + far) / law.width(far));
            rays.push([x.x, x.y, x.z, v.x, v.y, v.z]);
            through.push((impact < 1.0 && rising < 0.0) != (mouth == law.other));
        }
        for method in ["rk4", "dormand-prince", "bogacki-shampine"] {
            let mass = mass.map_or(String::new(), |mass| format!("mass = {mass}\n"));
            let scene = scene(&format!(
                "[law]\nkind = \"wormhole\"\nlength = {length}\n{mass}other_mouth = [300, 0, 0]\n[rays]\nbounding_sphere = {{ radius = 120 }}\n\
                 max_segments = 20000\nmethod = \"{method}\"\n"
            ));
            let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
            let is_beyond = |x: [f64; 3]| DVec3::from(x).distance(law.other) < DVec3::from(x).length();
            let escaped = ends.iter().filter(|end| end.status == Status::Escaped).count();
            let wrong = ends.iter().zip(&through).filter(|(end, through)| is_beyond(end.x) != **through).count();
            println!("{mass}{method}: {escaped} of {} escaped, {wrong} wrong", ends.len());
            assert_eq!((escaped, wrong), (rays.len(), 0), "{mass}{method}");
        }
    }
}

/// A pixel away from the mouth shows this side's sky, and one through it the other side's sky or objects, also in path tracing.
#[test]
fn each_side_has_its_own_sky_and_objects() {
    let gpu = gpu();
    let lamp = "[materials.a]\nkind = \"emissive\"\ncolor = [0, 0.5, 0]\n[[objects]]\nshape = \"sphere\"\ncenter = [90, 0, 4]\nmaterial = \"a\"\n";
    let (near, beyond) = ("[sky]\ncolor = [1, 0, 0]\n", "[sky.other_side]\ncolor = [0, 0, 1]\n");
    for (ahead, rest, transport, expected) in [
        (9, format!("{near}{beyond}"), "direct", [1.0, 0.0, 0.0]),
        (0, format!("{near}{beyond}"), "direct", [0.0, 0.0, 1.0]),
        (0, near.to_owned(), "direct", [1.0, 0.0, 0.0]),
        (0, format!("{near}{beyond}{lamp}"), "direct", [0.0, 0.5, 0.0]),
        (9, format!("{near}{lamp}"), "path-tracing", [1.0, 0.0, 0.0]),
        (0, format!("{near}{lamp}"), "path-tracing", [0.0, 0.5, 0.0]),
    ] {
        let scene = scene(&format!(
            "[image]\nsize = [1, 1]\n[camera]\nposition = [0, 0, 6]\nlook_at = [0, 0, {ahead}]\nfov = 1\n[law]\nkind = \"wormhole\"\n\
             other_mouth = [90, 0, 0]\n[rays]\nbounding_sphere = {{ radius = 30 }}\nmethod = \"dormand-prince\"\nlighting = \"{transport}\"\n{rest}"
        ));
        let picture = Renderer::new(&gpu, &scene, RenderSettings::default()).unwrap().render().unwrap();
        let color = DVec3::from_array([0, 1, 2].map(|channel| f64::from(picture.band.color[channel][0])));
        assert_eq!(color, DVec3::from_array(expected), "towards z = {ahead} by {transport}, {rest}");
    }
}
