//! Tests volumes that are much thinner than the steps of paths through them.

use bentray::program::{Layer, Mode, ProgramOptions, Schedule};
use bentray::render::{RenderSettings, Starts, Tracer};
use glam::DVec3;

use crate::shaders::Random;
use crate::support::{gpu, scene};
use crate::volumes::lights_of;

/// A shell of a thousandth of a unit, of three kinds, around a center that rays pass at most 7.5 units away.
const SHELLS: [&str; 3] = [
    "density = \"exp(-((r - 8)/1e-3)^2)\"\nemission = \"1e3/sqrt(pi)*n\"",
    "density = \"max(0, 1 - abs(r - 8)/1e-3)\"\nemission = \"1e3*n\"",
    "density = \"tanh((r - 8)/1e-4) - tanh((r - 8.001)/1e-4)\"\nemission = \"5e2*n\"",
];

/// Straight rays cross a shell of radius R twice at an angle whose cosine is √(1 − b²/R²), and its light is the inverse of that. Along bent
/// rays, the kinds of shells and the methods agree.
#[test]
fn no_method_steps_over_a_thin_shell() {
    let mut random = Random::new(23);
    let rays: Vec<[f64; 6]> = (0..1000)
        .map(|_| {
            let n = random.direction();
            let across = n.any_orthonormal_vector();
            let (b, turn) = (random.within(0.0, 7.5), random.within(0.0, std::f64::consts::TAU));
            let x = 30.0 * n + b * (turn.cos() * across + turn.sin() * n.cross(across));
            [x.x, x.y, x.z, -n.x, -n.y, -n.z]
        })
        .collect();
    for (law, methods) in [
        ("straight", &[""][..]),
        ("schwarzschild", &["planar", "rk4"]),
        ("kerr-newman\"\nspin = \"0.7", &["separated", "dormand-prince"]),
        // Far from the hole, most of the way is in the first and the last part of the orbit.
        ("kerr-newman\"\nmass = \"1e-3", &["separated", "dormand-prince"]),
    ] {
        let mut first: Option<Vec<f64>> = None;
        for (method, shell) in methods.iter().flat_map(|method| SHELLS.map(|shell| (method, shell))) {
            let method = if method.is_empty() { String::new() } else { format!("method = \"{method}\"\n") };
            let text = format!(
                "[law]\nkind = \"{law}\"\n[rays]\nbounding_sphere = {{ radius = 40 }}\n{method}[radiation]\nfrequencies = [1.0]\n\
                 [[volumes]]\n{shell}\n"
            )
            .replace("spin = \"0.7\"", "spin = 0.7")
            .replace("mass = \"1e-3\"", "mass = 1e-3");
            let found: Vec<f64> = lights_of(&scene(&text), &rays).0.iter().map(|light| light[0].intensity).collect();
            let expected = first.get_or_insert_with(|| match law {
                "straight" => rays.iter().map(straight_through_shell).collect(),
                _ => found.clone(),
            });
            let mut off: Vec<f64> =
                found.iter().zip(expected.iter()).map(|(one, two)| (one / two - 1.0).abs()).collect();
            off.sort_by(f64::total_cmp);
            // Rounding of positions limits the light, and rays count as unsettled. The shells differ by their thickness over their radius, and positions are rounded to 2e-6.
            assert!(off[990] < 4e-3 && off[999] < 3e-2, "{text}: {} {}", off[990], off[999]);
        }
    }
}

/// A wall is found wherever a piece of a path ends, also if its formula may have edges.
#[test]
fn walls_at_the_ends_of_pieces_are_found() {
    let mut random = Random::new(31);
    let rays: Vec<[f64; 6]> =
        (0..2000).map(|_| [-90.0, random.within(-20.0, 20.0), random.within(-60.0, 60.0), 1.0, 0.0, 0.0]).collect();
    for (law, method) in [("schwarzschild", "planar"), ("kerr-newman", "separated"), ("kerr-newman", "dormand-prince")]
    {
        let of = |distance: &str| {
            let text = format!(
                "[law]\nkind = \"{law}\"\n[rays]\nbounding_sphere = {{ radius = 100 }}\nmethod = \"{method}\"\n[radiation]\n\
                 frequencies = [1.0]\n[[volumes]]\nshape = \"sphere\"\nradius = 80\ndensity = \"exp(-((r - {distance} - 1.4)/0.08)^2)\"\n\
                 emission = \"n\"\n"
            );
            lights_of(&scene(&text), &rays).0
        };
        let (smooth, edged) = (of("sqrt(z^2)"), of("abs(z)"));
        for ((one, two), ray) in smooth.iter().zip(&edged).zip(&rays) {
            let (one, two) = (one[0].intensity, two[0].intensity);
            assert!((one - two).abs() < 5e-3 * one.max(0.1), "{law} {method} {ray:?}: {one} {two}");
        }
    }
}

fn straight_through_shell(ray: &[f64; 6]) -> f64 {
    let (x, v) = (DVec3::from_slice(&ray[..3]), DVec3::from_slice(&ray[3..]));
    let b2 = x.length_squared() - x.dot(v).powi(2);
    2.0 / (1.0 - b2 / 64.0).sqrt()
}

/// A thin slab of opaque matter on the equator shines as a black body of its redshift: that of the surface of a disk in the same plane, whose
/// matter moves likewise, also within the last stable orbit.
#[test]
fn a_thin_slab_is_a_disk() {
    let mut random = Random::new(29);
    let eye = DVec3::new(40.0, 5.0, 25.0);
    let rays: Vec<[f64; 6]> = (0..200)
        .map(|_| {
            let (r, turn) = (random.within(1.5, 11.0), random.within(0.0, std::f64::consts::TAU));
            let d = (DVec3::new(r * turn.cos(), r * turn.sin(), 0.0) - eye).normalize();
            [eye.x, eye.y, eye.z, d.x, d.y, d.z]
        })
        .collect();
    let kerr = "[law]\nkind = \"kerr-newman\"\nspin = 0.7\n[rays]\nbounding_sphere = { radius = 100 }\n";
    let schwarzschild = "[law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 100 }\n";
    for (law, method) in [(kerr, "separated"), (kerr, "dormand-prince"), (schwarzschild, "planar")] {
        let text = format!("{law}method = \"{method}\"\n");
        let disk = format!(
            "{text}[materials.matter]\nkind = \"accretion\"\ntemperature = 7000\n[[objects]]\nshape = \"disk\"\n\
             normal = [0, 0, 1]\nradius = 12\nmaterial = \"matter\"\n"
        );
        // Low frequencies, at which I = g³ B(ν/g) is proportional to g.
        let slab = format!(
            "{text}[radiation]\nfrequencies = [1e-4]\n[[volumes]]\nshape = \"cylinder\"\nradius = 12\n\
             height = 2e-4\naxis = [0, 0, 1]\nflow = \"prograde-orbit\"\nsource = {{ black_body = 1 }}\nabsorption = 1e6\n"
        );
        let layers = Layer::ALL.into_iter().filter(|layer| layer.is_of_crossings()).collect();
        let options = ProgramOptions { schedule: Schedule::Fused, layers, ..ProgramOptions::default() };
        let settings = RenderSettings { options, ..RenderSettings::default() };
        let (gpu, disk) = (gpu(), scene(&disk));
        let mut tracer = Tracer::new(&gpu, &disk, settings, Mode::Trace).unwrap();
        tracer.follow(Starts::Given(&rays)).unwrap();
        let shifts: Vec<Option<f64>> =
            tracer.crossings().iter().map(|all| all.iter().flatten().next()?.redshift).collect();
        let (found, _) = lights_of(&scene(&slab), &rays);
        let pairs = shifts.iter().zip(&found).filter_map(|(g, light)| Some((light[0].intensity, (*g)?)));
        let mut off: Vec<f64> = pairs.map(|(light, g)| (light * 1e12 * ((1e-4 / g).exp() - 1.0) - 1.0).abs()).collect();
        off.sort_by(f64::total_cmp);
        // The slab's own thickness matters where g changes most, at the horizon.
        let (count, median) = (off.len(), off[off.len() / 2]);
        assert!(count > 120 && median < 1e-5 && off[count - 1] < 1e-2, "{method}: {count} {median} {}", off[count - 1]);
    }
}
