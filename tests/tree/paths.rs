//! Single rays through media inside objects.

use crate::support::lens::{Fate, columns, lenses, number, vector};
use crate::support::scene;
use crate::support::tree::{Interface, Meeting, Met, Ray, Tracer};
use glam::{DQuat, DVec3};

/// The allowed error of an answer, relative to sizes from 1 to 30.
const CLOSE: f64 = 1e-10;

fn surface(met: Met, name: &str) -> Meeting {
    let Met::Surface(meeting) = met else { panic!("{name}: {met:?}") };
    meeting
}

fn check(name: &str, what: &str, found: DVec3, expected: DVec3) {
    let off = found.distance(expected);
    assert!(off < CLOSE, "{name}: {what} off by {off:e}");
}

/// Returns the reflectance, the reflected and the transmitted direction.
fn parts(interface: Interface, d: DVec3) -> (f64, DVec3, DVec3) {
    match interface {
        Interface::Matched => (0.0, d, d),
        Interface::Total { reflected } => (1.0, reflected, d),
        Interface::Split { reflected, transmitted, reflectance } => (reflectance, reflected, transmitted),
    }
}

/// Compares every row of the table: where the ray enters, its direction inside, where it leaves and how.
#[test]
fn rays_pass_lenses_as_the_table_says() {
    for lens in lenses() {
        let scene = lens.scene();
        let tracer = Tracer::new(&scene);
        let name = lens.name;
        let mut ray = tracer.ray(lens.origin, lens.direction.normalize());
        if let Some((x, d)) = lens.entry {
            let meeting = surface(tracer.next(&ray), name);
            check(name, "entry", meeting.ray.x, x);
            let (interface, _, across) = tracer.cross(&meeting);
            let (reflectance, _, transmitted) = parts(interface, meeting.ray.d);
            check(name, "direction inside", transmitted, d);
            let expected = lens.entry_reflectance.unwrap_or(reflectance);
            assert!((reflectance - expected).abs() < CLOSE, "{name}: {reflectance}");
            ray = across;
        }
        let inside = ray.clone();
        let met = tracer.next(&ray);
        let Some((x, d)) = lens.exit else {
            assert!(matches!(met, Met::Lost) && lens.fate == Fate::Centre, "{name}: {met:?}");
            continue;
        };
        let meeting = surface(met, name);
        check(name, "exit", meeting.ray.x, x);
        check(name, "direction at the exit", meeting.ray.d, d);
        let (interface, back, across) = tracer.cross(&meeting);
        let (reflectance, reflected, transmitted) = parts(interface, meeting.ray.d);
        let expected = lens.exit_reflectance.unwrap_or(reflectance);
        assert!((reflectance - expected).abs() < CLOSE, "{name}: {reflectance}");
        let total = lens.fate == Fate::Total;
        assert_eq!(matches!(interface, Interface::Total { .. }), total, "{name}");
        check(name, "onward direction", if total { reflected } else { transmitted }, lens.onward.unwrap());
        if let (Some(swept), true) = (lens.swept, lens.object.contains("sphere")) {
            let center = lens.bound.center;
            let whole = ((swept - angle(&inside, &meeting.ray, center)) / std::f64::consts::TAU).abs();
            assert!((whole - whole.round()).abs() < CLOSE, "{name}: {whole} turns off");
        }
        // A ray away from the surface escapes or stays inside.
        let next = tracer.next(if total { &back } else { &across });
        assert_eq!(matches!(next, Met::Sky(_)), !total, "{name}: {next:?}");
    }
}

/// Returns the angle from the ray's start to its end around a center, in its initial direction, modulo whole turns.
fn angle(start: &Ray, end: &Ray, center: DVec3) -> f64 {
    let from = (start.x - center).normalize();
    let ahead = start.d.reject_from_normalized(from).normalize_or_zero();
    let to = end.x - center;
    // Rays through the center leave on the opposite side.
    if ahead == DVec3::ZERO { std::f64::consts::PI } else { to.dot(ahead).atan2(to.dot(from)) }
}

/// Checks points on the path into the center, where the surface of an opaque ball is placed.
#[test]
fn spirals_go_through_their_points() {
    let lenses = lenses();
    for row in columns(include_str!("../tables/spirals.tsv")) {
        let lens = lenses.iter().find(|lens| lens.name == row[0]).unwrap();
        let ball = "shape = \"sphere\"\nmaterial = \"black\"\nradius";
        let text = format!(
            "[rays]\nbounding_sphere = {{ radius = 12 }}\n[[objects]]\n{}\n[materials.black]\n[[objects]]\n{ball} = {}\n",
            lens.object, row[1]
        );
        let scene = scene(&text);
        let tracer = Tracer::new(&scene);
        let mut ray = tracer.ray(lens.origin, lens.direction.normalize());
        if lens.entry.is_some() {
            (_, _, ray) = tracer.cross(&surface(tracer.next(&ray), row[0]));
        }
        let meeting = surface(tracer.next(&ray), row[0]);
        assert_eq!(meeting.object, 1, "{} at {}", row[0], row[1]);
        check(row[0], "position", meeting.ray.x, vector(row[3]).unwrap());
        check(row[0], "direction", meeting.ray.d, vector(row[4]).unwrap());
        let turns = (number(row[2]).unwrap() - angle(&ray, &meeting.ray, lens.bound.center)) / std::f64::consts::TAU;
        assert!((turns - turns.round()).abs() < CLOSE, "{}: {turns} turns off", row[0]);
    }
}

/// Treated as outgoing, an ingoing ray takes the path of its mirror image in the sphere through its start.
#[test]
fn continued_spirals_go_out() {
    let text = "[rays]\nbounding_sphere = { radius = 12 }\n[[objects]]\nshape = \"sphere\"\nradius = 4\n\
        interior = { kind = \"inverse-r\", k = 6, ingoing = \"continue\" }\n";
    let scene = scene(text);
    let tracer = Tracer::new(&scene);
    let x = DVec3::new(1.0, 0.5, -0.7);
    let d = DVec3::new(-0.3, -1.0, 0.2).normalize();
    let outward = d - 2.0 * d.dot(x.normalize()) * x.normalize();
    let [a, b] = [d, outward].map(|d| surface(tracer.next(&tracer.ray(x, d)), "spiral"));
    check("spiral", "exit", a.ray.x, b.ray.x);
    check("spiral", "direction", a.ray.d, b.ray.d);
    // If the ray came from outside, it is outside again at the point where it enters.
    let meeting = surface(tracer.next(&tracer.ray(DVec3::new(-8.0, 1.0, 0.0), DVec3::X)), "spiral");
    let (_, _, across) = tracer.cross(&meeting);
    let again = surface(tracer.next(&across), "spiral");
    check("spiral", "second meeting", again.ray.x, meeting.ray.x);
    let (interface, _, out) = tracer.cross(&again);
    let (_, _, transmitted) = parts(interface, again.ray.d);
    let across = meeting.normal;
    check("spiral", "direction outside", transmitted, DVec3::X - 2.0 * DVec3::X.dot(across) * across);
    assert!(matches!(tracer.next(&out), Met::Sky(_)));
}

/// Rays from one point of a Maxwell fisheye meet at the opposite point; parallel rays through a Luneburg lens meet on its surface.
#[test]
fn lenses_have_their_focus() {
    let sphere = |interior: &str| {
        format!(
            "[rays]\nbounding_sphere = {{ radius = 9 }}\n[[objects]]\nshape = \"sphere\"\nradius = 2\ninterior = {{ {interior} }}\n"
        )
    };
    let luneburg = scene(&sphere("kind = \"luneburg\""));
    let fisheye = scene(&sphere("kind = \"maxwell-fisheye\", n0 = 3"));
    let turn = DQuat::from_rotation_arc(DVec3::X, DVec3::new(2.0, -1.0, 2.0) / 3.0);
    for i in 0..1000 {
        let (r, angle) = (2.0 * ((f64::from(i) + 0.5) / 1000.0).sqrt(), 2.399_963 * f64::from(i));
        let aside = DVec3::new(0.0, r * angle.cos(), r * angle.sin());
        let tracer = Tracer::new(&luneburg);
        let meeting = surface(tracer.next(&tracer.ray(turn * (aside - 5.0 * DVec3::X), turn * DVec3::X)), "luneburg");
        let (_, _, across) = tracer.cross(&meeting);
        let end = surface(tracer.next(&across), "luneburg");
        let off = end.ray.x.distance(turn * (2.0 * DVec3::X));
        // A grazing ray meets the surface at a small angle, proportional to its chord.
        assert!(off < 1e-12 / (1.0 - r / 2.0).sqrt().max(1e-2), "ray {i}: off by {off:e}");
        let tracer = Tracer::new(&fisheye);
        let x = turn * DVec3::new(-1.0, 0.0, 0.0);
        let d = turn * (aside + 0.3 * DVec3::X).normalize();
        let end = surface(tracer.next(&tracer.ray(x, d)), "fisheye");
        // The circle through x with the tangent d also contains −a² x/|x|²:
        // from its points the chord between these two has a constant angle.
        let image = -4.0 * x / x.length_squared();
        let seen = (x - end.ray.x).angle_between(image - end.ray.x);
        let turned = std::f64::consts::PI - d.angle_between(image - x);
        assert!((seen - turned).abs() < 1e-12, "ray {i}: {seen}, {turned} on the circle");
        let normal = (end.ray.x - x).cross(image - x);
        assert!(normal.dot(d).abs() < 1e-12, "ray {i} leaves its plane");
    }
}
