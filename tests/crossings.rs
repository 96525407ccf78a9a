//! Tests the values of crossings: against a table, against closed forms, and in every schedule.

use bentray::program::{Layer, Mode, ProgramOptions, Schedule};
use bentray::render::{Crossing, Plane, RenderSettings, Renderer, Starts, Tracer};
use bentray::scene::Scene;
use glam::DVec3;

use crate::oracle::{rows, vector};
use crate::spacetimes::typed;
use crate::support::{gpu, scene};

/// All layers of crossings.
fn layers() -> Vec<Layer> {
    Layer::ALL.into_iter().filter(|layer| layer.is_of_crossings()).collect()
}

fn settings(schedule: Schedule) -> RenderSettings {
    let options = ProgramOptions { schedule, layers: layers(), ..ProgramOptions::default() };
    RenderSettings { options, ..RenderSettings::default() }
}

/// Returns the crossings of a given ray.
fn traced(scene: &Scene, ray: [f64; 6]) -> Vec<Crossing> {
    let gpu = gpu();
    let mut tracer = Tracer::new(&gpu, scene, settings(Schedule::Fused), Mode::Trace).unwrap();
    tracer.follow(Starts::Given(&[ray])).unwrap();
    tracer.crossings()[0].iter().flatten().copied().collect()
}

/// Returns the distance of two angles.
fn turn(a: f64, b: f64) -> f64 {
    (a - b).sin().atan2((a - b).cos()).abs()
}

/// Checks r, position and g of given rays in 64 bits, also under the law as a line element.
#[test]
fn crossings_are_where_series_say() {
    for row in rows(include_str!("tables/disc_crossings.tsv")) {
        let (spin, origin, way): (f64, _, _) = (row[1].parse().unwrap(), vector(row[2]), vector(row[3]));
        let kerr = format!("kind=\"kerr-newman\";spin={spin}");
        for (law, bound) in [(kerr.replace(';', "\n"), 1e-9), (typed(&kerr), 1e-7)] {
            let scene = scene(&format!(
                "[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 200 }}\nmethod = \"dormand-prince\"\ntolerance = 1e-12\n\
                 precision = \"f64\"\nmax_segments = 20000\n[materials.m]\nkind = \"accretion\"\nopacity = 0.5\n[[objects]]\n\
                 shape = \"disk\"\nmaterial = \"m\"\nnormal = [0, 0, 1]\nradius = 190\ninner_radius = 0.5\n"
            ));
            let [x, v] = [origin, way].map(|vector| vector.to_array());
            let found = traced(&scene, [x[0], x[1], x[2], v[0], v[1], v[2]]);
            let told: Vec<&str> = row[4].split("; ").collect();
            assert_eq!(found.len(), told.len(), "{}", row[0]);
            for (found, told) in found.iter().zip(told) {
                let words: Vec<Option<f64>> = told.split(' ').map(|word| word.parse().ok()).collect();
                let off = (found.x[0] - words[0].unwrap()).hypot(found.x[1] - words[1].unwrap());
                assert!(off < bound * found.radius, "{}: off by {off:e}", row[0]);
                let told_g = words[3].unwrap_or(found.redshift.unwrap());
                assert!((found.redshift.unwrap() / told_g - 1.0).abs() < 1e-6, "{}: {found:?}", row[0]);
                if law.contains("kerr-newman") {
                    assert!((found.radius / words[2].unwrap() - 1.0).abs() < bound, "{}: {found:?}", row[0]);
                }
            }
        }
    }
}

/// Checks t and φ along a principal null ray, which has dt = (r² + a²)/Δ dr and dφ = a/Δ dr in Boyer–Lindquist coordinates.
#[test]
fn principal_rays_take_the_time_of_their_closed_form() {
    for (spin, charge) in [(0.9_f64, 0.0), (1.0, 0.0), (0.3, 0.4), (0.8, 0.9)] {
        let theta = 0.7_f64;
        let [outer, inner] = [20.0, 4.0];
        let scene = scene(&format!(
            "[law]\nkind = \"kerr-newman\"\nspin = {spin}\ncharge = {charge}\naxis = [0, 0, 1]\n[rays]\nbounding_sphere = {{ radius = 50 }}\n\
             method = \"dormand-prince\"\ntolerance = 1e-12\nprecision = \"f64\"\nmax_segments = 20000\n[materials.m]\nkind = \"emissive\"\n\
             color = [1, 1, 1]\n[[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\nradius = {:?}\n",
            (inner * inner + (spin * theta.sin()).powi(2)).sqrt()
        ));
        let delta = |r: f64| r * r - 2.0 * r + spin * spin + charge * charge;
        let place = |r: f64| {
            let [re, im] = [r * theta.sin(), spin * theta.sin()];
            DVec3::new(re, im, r * theta.cos())
        };
        // With φ̃ = 0 at the start. Into the past and inwards, dφ̃ = 2a/Δ dr: once for the ray, and once for φ̃ itself.
        let slope = 2.0 * spin / delta(outer);
        let x = place(outer);
        let v = -DVec3::new(theta.sin(), 0.0, theta.cos()) - slope * DVec3::new(-x.y, x.x, 0.0);
        let found = traced(&scene, [x.x, x.y, x.z, v.x, v.y, v.z]);
        let integral = |of: &dyn Fn(f64) -> f64| {
            // By Simpson's rule in ln r.
            const PARTS: u32 = 20_000;
            let h = (outer / inner).ln() / f64::from(PARTS);
            let at = |k: u32| inner * (h * f64::from(k)).exp();
            let weight = |k: u32| if k == 0 || k == PARTS { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
            (0..=PARTS).map(|k| weight(k) * of(at(k)) * at(k)).sum::<f64>() * h / 3.0
        };
        let time = integral(&|r| (r * r + spin * spin) / delta(r));
        let turned = integral(&|r| spin / delta(r));
        let Crossing { radius, time: found_time, .. } = found[0];
        assert!((radius - inner).abs() < 1e-8, "{radius}");
        assert!((found_time.unwrap() - time).abs() < 1e-8 * time, "{found_time:?} for {time}");
        let start = scene.law.spherical(x).unwrap().azimuth;
        assert!(turn(found[0].azimuth - start, -turned) < 1e-8, "{} for {turned}", found[0].azimuth - start);
    }
}

/// Around a hole without spin, a static shell sees light of impact parameter b at an angle with the sine b √(1 − 2M/r) / r, and
/// g is the ratio of two clocks. In flat space the angle is that of the line.
#[test]
fn shells_see_light_at_the_angle_of_its_impact_parameter() {
    let (far, shell) = (30.0_f64, 6.0_f64);
    let clock = |r: f64| (1.0 - 2.0 / r).sqrt();
    for (law, flat) in [
        ("kind = \"kerr-newman\"", false),
        ("kind = \"schwarzschild\"", false),
        ("kind = \"schwarzschild\"\nform = \"geodesic\"", false),
        ("kind = \"straight\"", true),
    ] {
        let scene = scene(&format!(
            "[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 50 }}\nmethod = \"dormand-prince\"\ntolerance = 1e-12\nprecision = \"f64\"\n\
             max_segments = 20000\n[materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n[[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\n\
             radius = {shell}\n"
        ));
        let found = traced(&scene, [0.0, -far, 0.0, 0.1, 1.0, 0.0]);
        let told = if flat {
            far * (0.1 / 1.01_f64.sqrt()) / shell
        } else {
            // In Kerr–Schild coordinates and in those of Schwarzschild one velocity belongs to different rays.
            let b = match law {
                "kind = \"kerr-newman\"" => {
                    let pull = 2.0 / far;
                    // |v|² + f (1 − l·v)² = 1 for v = s (0.1, 1) with l = −y.
                    let whole = 1.01 + pull;
                    let speed = ((pull * pull - whole * (pull - 1.0)).sqrt() - pull) / whole;
                    far * 0.1 * speed / (1.0 - pull * (1.0 + speed))
                }
                _ => far * 0.1 / (1.0 + clock(far).powi(2) * 0.01).sqrt(),
            };
            b * clock(shell) / shell
        };
        let sine = found[0].angle.unwrap().sin();
        assert!((sine / told - 1.0).abs() < 1e-8, "{law}: {sine} for {told}");
        if flat {
            continue;
        }
        let g = found[0].redshift.unwrap();
        assert!((g * clock(far) / clock(shell) - 1.0).abs() < 1e-10, "{law}: {g}");
    }
}

/// The layers of an image agree with the rays of its pixels, in every schedule and in tiles.
#[test]
fn layers_have_the_crossings_of_rays() {
    let gpu = gpu();
    let scene = scene(
        "[image]\nsize = [24, 16]\n[camera]\nposition = [18, 3, 4]\nobserver = \"prograde-orbit\"\nup = [0, 0, 1]\n[law]\n\
         kind = \"kerr-newman\"\nspin = 0.9\naxis = [0, 0, 1]\n[rays]\nbounding_sphere = { radius = 60 }\nmethod = \"dormand-prince\"\n\
         tolerance = 1e-6\n[materials.m]\nkind = \"accretion\"\nopacity = 0.5\n[[objects]]\nshape = \"disk\"\nmaterial = \"m\"\n\
         normal = [0, 0, 1]\nradius = 15\ninner_radius = 1.5\n"
            .replace("position = [18, 3, 4]", "position = [18, 3, 0]\nlook_at = [0, 0, 0]")
            .replace("up = [0, 0, 1]", "up = [0, 0.3, 1]")
            .as_str(),
    );
    let mut all: Option<Vec<(Layer, Plane)>> = None;
    for (schedule, tile_pixels) in
        Schedule::ALL.map(|schedule| (schedule, u64::MAX)).into_iter().chain([(Schedule::Fused, 64)])
    {
        let settings = RenderSettings { tile_pixels, ..settings(schedule) };
        let layers = Renderer::new(&gpu, &scene, settings).unwrap().render().unwrap().band.layers;
        assert!(all.is_none_or(|all| all == layers), "{schedule:?}, {tile_pixels}");
        all = Some(layers);
    }
    let pixels: Vec<[u32; 2]> = (0..24 * 16).map(|i| [i % 24, i / 24]).collect();
    let mut tracer = Tracer::new(&gpu, &scene, settings(Schedule::Fused), Mode::Pixels).unwrap();
    tracer.follow(Starts::Pixels(&pixels, 24)).unwrap();
    let mut found = [0; 4];
    for (layer, plane) in all.unwrap() {
        let Plane::Crossings(orders) = plane else { panic!("{layer:?}") };
        for (pixel, crossings) in tracer.crossings().iter().enumerate() {
            for (k, crossing) in crossings.iter().enumerate() {
                found[k] += usize::from(crossing.is_some());
                let told = crossing.map_or(0.0, |crossing| crossing.value(layer)) as f32;
                assert!(
                    orders[k][pixel].to_bits() == told.to_bits(),
                    "{layer:?} {pixel} {k}: {} for {told}",
                    orders[k][pixel]
                );
            }
        }
    }
    assert!(found[0] > 100 && found[1] > 10, "{found:?}");
}
