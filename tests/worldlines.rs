//! Freely falling observers, and observers on given worldlines: their positions at each proper time, compared with closed forms.

use bentray::model::Law;
use bentray::model::camera::{Event, Path, WorldlineError, fall};
use bentray::scene::{Observer, Scene};
use glam::{DVec3, DVec4, dvec3};

use crate::spacetimes::typed;
use crate::support::scene;

fn law(text: &str) -> std::sync::Arc<dyn Law> {
    scene(&format!("[law]\n{text}\n[rays]\nbounding_sphere = {{ radius = 100 }}\n")).law
}

fn begun(law: &dyn Law, frame: Observer, x: DVec3) -> Event {
    Event { x, t: 0.0, u: law.observer(frame, x).unwrap().unwrap() }
}

fn square(law: &dyn Law, event: &Event) -> f64 {
    event.u.dot(law.metric(event.x, event.t).unwrap() * event.u)
}

/// A fall from rest far away to the center takes the proper time √(2/9M) r^(3/2), with and without a coordinate singularity at the horizon.
#[test]
fn who_falls_from_rest_takes_as_long_as_closed_forms_say() {
    let spent = |from: f64, to: f64| (from.powf(1.5) - to.powf(1.5)) * (2.0 / 9.0 / 1.5_f64).sqrt();
    for (text, to) in [
        ("kind = \"schwarzschild\"\nmass = 1.5", 3.5),
        ("kind = \"reissner-nordstrom\"\nmass = 1.5", 3.5),
        ("kind = \"kerr-newman\"\nmass = 1.5", 0.4),
    ] {
        let law = law(text);
        let start = begun(&*law, Observer::Infalling, dvec3(0.0, 12.0, 5.0));
        let end = fall(&*law, start, spent(13.0, to)).unwrap();
        assert!((end.x.length() - to).abs() < 1e-8 && (square(&*law, &end) + 1.0).abs() < 1e-8, "{text}: {end:?}");
        assert!(end.x.cross(start.x).length() < 1e-8);
    }
    // In these coordinates nothing passes a horizon in finite time, and no observer continues beyond the center.
    let outside = law("kind = \"schwarzschild\"");
    let end = fall(&*outside, begun(&*outside, Observer::Infalling, 8.0 * DVec3::X), 20.0).unwrap_err();
    assert!(end > 5.0 && end < 10.5, "{end}");
    let middle = law("kind = \"kerr-newman\"");
    let end = fall(&*middle, begun(&*middle, Observer::Infalling, 8.0 * DVec3::X), 20.0).unwrap_err();
    assert!((end - (2.0_f64 / 9.0 * 512.0).sqrt()).abs() < 0.01, "{end}");
}

/// Circular orbits stay circular. On any path around a rotating black hole energy,
/// angular momentum and the Carter constant are conserved, also by its line element.
#[test]
fn who_is_left_to_himself_keeps_what_light_keeps() {
    for text in [
        "kind = \"kerr-newman\"\nspin = 0.9",
        "kind = \"schwarzschild\"",
        "kind = \"reissner-nordstrom\"\ncharge = 0.5\ncosmological_constant = 0.0002",
    ] {
        let law = law(text);
        for frame in [Observer::ProgradeOrbit, Observer::RetrogradeOrbit] {
            let start = begun(&*law, frame, dvec3(10.0, 0.0, 0.0));
            let end = fall(&*law, start, 150.0).unwrap();
            let turning = start.u.y / 10.0;
            let told = 10.0 * dvec3((150.0 * turning).cos(), (150.0 * turning).sin(), 0.0);
            assert!(end.x.distance(told) < 1e-6, "{text}, {frame:?}: {} for {told}", end.x);
            assert!((end.t - 150.0 * start.u.w).abs() < 1e-6);
        }
    }
    let kerr = "kind=\"kerr-newman\";spin=0.9";
    let [own, written] = [law(&kerr.replace(';', "\n")), law(&typed(kerr))];
    let start = begun(&*own, Observer::Boosted(dvec3(-0.2, 0.35, 0.25)), dvec3(9.0, 1.0, 2.0));
    let [end, other] = [&own, &written].map(|law| fall(&**law, start, 60.0).unwrap());
    assert!(end.x.distance(other.x) < 1e-6 && (end.t - other.t).abs() < 1e-6, "{end:?} {other:?}");
    let kept = |event: &Event| {
        let lowered = own.metric(event.x, 0.0).unwrap() * event.u;
        [lowered.w, event.x.cross(lowered.truncate()).z, lowered.dot(event.u)]
    };
    for (before, after) in kept(&start).into_iter().zip(kept(&end)) {
        assert!((before - after).abs() < 1e-8 * before.abs().max(1.0), "{before} {after}");
    }
}

/// In expanding space moving objects slow down: momentum falls as space grows.
#[test]
fn who_moves_slows_down_as_space_grows() {
    let law = law(
        "kind = \"metric\"\nline_element = \"-dt^2 + exp(2*H*t)*(dx^2 + dy^2 + dz^2)\"\nscale = \"5\"\nparameters = { H = 0.05 }\ntime = 2",
    );
    let start = begun(&*law, Observer::Boosted(dvec3(0.0, 0.6, 0.0)), DVec3::ZERO);
    let end = fall(&*law, start, 12.0).unwrap();
    let metric = law.metric(end.x, end.t).unwrap();
    let momentum = end.u.y * metric.y_axis.y.sqrt();
    assert!((momentum / (0.75 * (-0.05 * end.t).exp()) - 1.0).abs() < 1e-9, "{momentum}");
    assert!((square(&*law, &end) + 1.0).abs() < 1e-9);
    let speed = end.velocity(&*law).unwrap();
    let told = momentum / momentum.hypot(1.0);
    assert!(speed.distance(dvec3(0.0, told, 0.0)) < 1e-9, "{speed}");
}

/// Checks given worldlines: a straight one at constant speed, and a circle with a comoving frame; an invalid worldline is rejected.
#[test]
fn worldlines_have_a_time_of_their_own() {
    let flat = law("kind = \"straight\"");
    let straight = Path::through(vec![DVec4::new(1.0, 0.0, 0.0, 5.0), DVec4::new(7.0, 0.0, 0.0, 15.0)]).unwrap();
    let event = straight.after(&*flat, 4.0).unwrap();
    assert!((event.t - 10.0).abs() < 1e-12 && event.x.distance(dvec3(4.0, 0.0, 0.0)) < 1e-12, "{event:?}");
    assert!(event.velocity(&*flat).unwrap().distance(dvec3(0.6, 0.0, 0.0)) < 1e-12);
    assert_eq!(
        straight.after(&*flat, 8.5).map_err(|end| matches!(end, WorldlineError::Ends(s) if (s - 8.0).abs() < 1e-9)),
        Err(true)
    );
    let hole = law("kind = \"kerr-newman\"\nspin = 0.7");
    let orbit = begun(&*hole, Observer::ProgradeOrbit, dvec3(12.0, 0.0, 0.0));
    let turning = orbit.u.y / orbit.u.w / 12.0;
    let circle = |k: u32| {
        let t = f64::from(k);
        let angle = turning * t;
        DVec4::new(12.0 * angle.cos(), 12.0 * angle.sin(), 0.0, t)
    };
    let round = Path::through((0..200).map(circle).collect()).unwrap();
    let event = round.after(&*hole, 100.0 / orbit.u.w).unwrap();
    assert!((event.t - 100.0).abs() < 1e-4 && event.x.distance(circle(100).truncate()) < 1e-4, "{event:?}");
    let fast =
        Path::through(vec![DVec4::ZERO, DVec4::new(1.0, 0.0, 0.0, 2.0), DVec4::new(9.0, 0.0, 0.0, 3.0)]).unwrap();
    assert!(matches!(fast.after(&*flat, 9.0), Err(WorldlineError::TooFast(1 | 2))));
    assert_eq!(Path::through(vec![DVec4::W, DVec4::X]), Err(WorldlineError::NotLater(1)));
}

/// A video of a fall has frames at equal steps of proper time, through the horizon.
#[test]
fn cameras_fall_by_their_own_clocks() {
    let seen = |proper: f64| -> Scene {
        scene(&format!(
            "[camera]\nposition = [0, -8, 0]\nobserver = \"infalling\"\nproper_time = {proper}\nlook_at = [0, 0.1, 0]\nup = [0, 0, 1]\n[law]\n\
             kind = \"kerr-newman\"\n[rays]\nbounding_sphere = {{ radius = 40 }}\n"
        ))
    };
    for proper in [0.0, 3.0, 9.3325, 10.4] {
        let camera = seen(proper).camera.unwrap();
        let r = (8.0_f64.powf(1.5) - proper * 4.5_f64.sqrt()).powf(2.0 / 3.0);
        assert!(camera.position.distance(dvec3(0.0, -r, 0.0)) < 1e-7, "{proper}: {}", camera.position);
        let law = seen(0.0).law;
        let [own, told] =
            [camera.observer, Observer::Infalling].map(|frame| law.observer(frame, camera.position).unwrap().unwrap());
        assert!(own.distance(told) < 1e-6, "{own} {told}");
    }
}
