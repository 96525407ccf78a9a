//! Tests matter that orbits in thin disks against closed forms and values with 15 digits.

use bentray::model::{black_body, matter};
use bentray::program::{Layer, ProgramOptions, Schedule};
use bentray::render::{Plane, RenderSettings, Renderer};
use bentray::scene::Observer;
use glam::DVec3;

use crate::oracle::{rows, vector};
use crate::shifts::{rendered, shifts};
use crate::spacetimes::typed;
use crate::support::{gpu, scene};

fn numbers(text: &str) -> Vec<f64> {
    text.split(' ').map(|word| word.parse().unwrap()).collect()
}

/// Checks E, L, Ω, uᵗ and the light of the orbits, also for the law as a line element, whose derivatives are differences.
#[test]
fn matter_moves_and_shines_as_closed_forms_say() {
    for row in rows(include_str!("tables/thin_discs.tsv")) {
        let spin: f64 = row[1].parse().unwrap();
        let kerr = format!("kind=\"kerr-newman\";spin={spin}");
        for (law, bound) in [(kerr.replace(';', "\n"), 3e-7), (typed(&kerr), 3e-6)] {
            let law = scene(&format!("[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 60 }}\n")).law;
            let (edge, orbits) = matter::orbits(&*law, 60.0, 4096).unwrap();
            let radius = |rho: f64| (rho * rho - spin * spin).sqrt();
            let off = radius(orbits[edge].rho) / row[2].parse::<f64>().unwrap() - 1.0;
            assert!(off.abs() < bound, "{}: the innermost stable orbit is off by {off:e}", row[0]);
            for told in row[3].split("; ").map(numbers) {
                // By Lagrange interpolation between the four nearest rows.
                let after = orbits.iter().position(|orbit| radius(orbit.rho) > told[0]).unwrap();
                let near = &orbits[after - 2..after + 2];
                let at = |of: &dyn Fn(&matter::Orbit) -> f64| -> f64 {
                    let weight = |i: usize| -> f64 {
                        let others = (0..4).filter(|k| *k != i).map(|k| radius(near[k].rho));
                        others.map(|r| (told[0] - r) / (radius(near[i].rho) - r)).product()
                    };
                    (0..4).map(|i| weight(i) * of(&near[i])).sum()
                };
                let found = [
                    ("E", at(&|orbit| orbit.energy)),
                    ("L", at(&|orbit| orbit.momentum)),
                    ("turning", at(&matter::Orbit::turning)),
                    ("clock", at(&|orbit| orbit.u.z)),
                    ("flux", at(&|orbit| orbit.flux)),
                ];
                for ((what, found), told) in found.into_iter().zip(&told[1..]) {
                    let off = found / told - 1.0;
                    assert!(off.abs() < bound, "{} at {}: {what} is off by {off:e}", row[0], radius(near[1].rho));
                }
            }
        }
    }
}

/// Without spin, three laws of black holes have identical matter, and an accretion disk has one appearance under all of them.
#[test]
fn discs_of_holes_without_spin_are_alike() {
    for (charge, others) in [
        (0.0, vec!["kind = \"schwarzschild\"", "kind = \"schwarzschild\"\nform = \"geodesic\""]),
        (0.6, vec!["kind = \"reissner-nordstrom\"\ncharge = 0.6"]),
    ] {
        let kerr = format!("kind = \"kerr-newman\"\ncharge = {charge}");
        let seen = |law: &str| {
            scene(&format!(
                "[image]\nsize = [24, 16]\n[camera]\nposition = [14, 2, 3]\nup = [0, 1, 0]\nfov = 60\nobserver = \"static\"\nredshift = true\n\
                 [law]\n{law}\naxis = [0, 1, 0]\n[rays]\nbounding_sphere = {{ radius = 60 }}\nmethod = \"dormand-prince\"\ntolerance = 1e-6\n\
                 [materials.m]\nkind = \"accretion\"\ntemperature = 7000\n[[objects]]\nshape = \"disk\"\nmaterial = \"m\"\n\
                 radius = 20\ninner_radius = 3\n"
            ))
        };
        let told = seen(&kerr);
        let (edge, orbits) = matter::orbits(&*told.law, 60.0, 512).unwrap();
        for law in others {
            let own = seen(law);
            let (own_edge, own_orbits) = matter::orbits(&*own.law, 60.0, 512).unwrap();
            assert_eq!(edge, own_edge, "{law}");
            for (a, b) in orbits.iter().zip(&own_orbits).skip(edge) {
                let pairs =
                    [(a.energy, b.energy), (a.momentum, b.momentum), (a.u.z, b.u.z), (a.turning(), b.turning())];
                let off = pairs.iter().map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
                assert!(
                    off < 1e-9 && (a.flux - b.flux).abs() <= 1e-6 * a.flux.abs() + 1e-12,
                    "{law} at {}: {off:e}",
                    a.rho
                );
            }
            let pictures = [&told, &own].map(rendered);
            let off = shifts(&pictures[0]).iter().zip(shifts(&pictures[1])).map(|(a, b)| (a - b).abs());
            // Pixels on edges may show another crossing.
            let wrong = off.filter(|off| *off > 1e-4).count();
            assert!(wrong <= 2, "{law}: {wrong} pixels are off");
        }
    }
}

/// Compares circular and infalling observers with closed forms.
#[test]
fn observers_round_holes_without_spin_move_as_they_should() {
    for law in
        ["kind = \"schwarzschild\"", "kind = \"reissner-nordstrom\"\ncharge = 0.5\ncosmological_constant = 0.0003"]
    {
        let law = scene(&format!(
            "[law]\n{law}\nmass = 1.5\ncenter = [1, 2, 3]\naxis = [0, 3, 4]\n[rays]\nbounding_sphere = {{ radius = 60 }}\n"
        ))
        .law;
        let axis = DVec3::new(0.0, 0.6, 0.8);
        let x = 11.0 * DVec3::new(0.0, 0.8, -0.6);
        let metric = law.metric(DVec3::new(1.0, 2.0, 3.0) + x, 0.0).unwrap();
        let of = |frame: Observer| law.observer(frame, DVec3::new(1.0, 2.0, 3.0) + x).unwrap().unwrap();
        for frame in [Observer::ProgradeOrbit, Observer::RetrogradeOrbit, Observer::Infalling, Observer::Zamo] {
            let u = of(frame);
            assert!((u.dot(metric * u) + 1.0).abs() < 1e-13 && u.w > 0.0, "{frame:?}: {u}");
        }
        let orbit = of(Observer::ProgradeOrbit);
        assert!(orbit.truncate().dot(axis.cross(x)) > 0.0);
        // The condition of a geodesic: ∂g_tt/∂r + Ω² ∂g_φφ/∂r = 0.
        let clock = |r: f64| -law.metric(DVec3::new(1.0, 2.0, 3.0) + r / 11.0 * x, 0.0).unwrap().w_axis.w;
        let slope = (clock(11.001) - clock(10.999)) / 0.002;
        let turning = orbit.truncate().length() / (11.0 * orbit.w);
        assert!((turning * turning / (0.5 * slope / 11.0) - 1.0).abs() < 1e-6, "{turning}");
        let falling = of(Observer::Infalling);
        assert!(((metric * falling).w + 1.0).abs() < 1e-13 && falling.truncate().dot(x) < 0.0);
    }
}

/// Inside the ISCO matter keeps E and L, and its fall accelerates.
#[test]
fn matter_falls_in_from_the_innermost_stable_orbit() {
    for law in ["kind=\"kerr-newman\"\nspin=0.7", "kind=\"kerr-newman\"\nspin=0.3\ncharge=0.5\naxis=[0, 1, 0]"] {
        let law = scene(&format!("[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 60 }}\n")).law;
        let [_, axis] = law.equator().unwrap();
        let (edge, orbits) = matter::orbits(&*law, 60.0, 1000).unwrap();
        let out = axis.any_orthonormal_vector();
        let mut slower = 0.0;
        for orbit in orbits[..edge].iter().rev().take_while(|orbit| orbit.rho > 2.2) {
            let (at, around) = (orbit.rho * out, axis.cross(out));
            let u = (orbit.u.x * out + orbit.u.y * around).extend(orbit.u.z);
            let lowered = law.metric(at, 0.0).unwrap() * u;
            let kept = [lowered.dot(u) + 1.0, lowered.w + orbits[edge].energy];
            assert!(kept.iter().all(|off| off.abs() < 1e-9), "{kept:?}");
            let momentum = orbit.rho * lowered.dot(around.extend(0.0));
            assert!((momentum - orbits[edge].momentum).abs() < 1e-9 && orbit.u.x < slower && orbit.flux == 0.0);
            slower = orbit.u.x;
        }
        assert!(slower < -0.01, "{slower}");
    }
}

/// Checks the colors of CIE illuminant A and of daylight, as closely as sums of lobes allow, and the brightness by Rayleigh–Jeans.
#[test]
fn black_bodies_have_their_colours() {
    for (kelvin, x, y) in [(2856.0, 0.4476, 0.4074), (6500.0, 0.3135, 0.3236), (15000.0, 0.2637, 0.2674)] {
        let color = black_body::color(kelvin).0;
        let xyz = DVec3::new(
            DVec3::new(0.4124, 0.3576, 0.1805).dot(color),
            DVec3::new(0.2126, 0.7152, 0.0722).dot(color),
            DVec3::new(0.0193, 0.1192, 0.9505).dot(color),
        );
        let sum = xyz.element_sum();
        let off = (xyz.x / sum - x).hypot(xyz.y / sum - y);
        assert!(off < 5e-3, "{kelvin} K is off by {off}");
        assert!((xyz.y - 1.0).abs() < 1e-3, "{}", xyz.y);
    }
    let brightness = |kelvin: f64| black_body::color(kelvin).1;
    assert!((brightness(2e7) - brightness(1e7) - 2.0_f64.ln()).abs() < 1e-3);
    // Wien: at low temperatures brightness is proportional to e^(−C₂/λT), and the visible light is red.
    let slope = (brightness(1010.0) - brightness(990.0)) / (1.0_f64 / 990.0 - 1.0 / 1010.0);
    assert!((1.44e7 / slope - 600.0).abs() < 60.0, "{slope}");
}

/// Returns the flux of the brightest ring around a black hole with this spin.
fn hottest(spin: f64) -> f64 {
    let law =
        scene(&format!("[law]\nkind = \"kerr-newman\"\nspin = {spin}\n[rays]\nbounding_sphere = {{ radius = 200 }}\n"))
            .law;
    let (_, orbits) = matter::orbits(&*law, 200.0, 4096).unwrap();
    orbits.iter().map(|orbit| orbit.flux).fold(0.0, f64::max)
}

/// Checks the crossings of rays with a disk, in the order of tracing: position, redshift and color. A few third crossings
/// are far out and at a grazing angle, which the sensitivity does not include: only 64 bits are checked there.
#[test]
fn light_of_discs_is_shifted_as_series_say() {
    for row in rows(include_str!("tables/disc_crossings.tsv")) {
        let (spin, origin, way): (f64, _, _) = (row[1].parse().unwrap(), vector(row[2]), vector(row[3]));
        let kerr = format!("kind=\"kerr-newman\";spin={spin}");
        let most = hottest(spin);
        for (k, crossing) in row[4].split("; ").enumerate() {
            let words: Vec<&str> = crossing.split(' ').collect();
            let number = |i: usize| words[i].parse::<f64>().unwrap();
            let rho = number(0).hypot(number(1));
            let bits = [("f32", 1e-6, 2e-5_f64.max(40.0 * row[5].parse::<f64>().unwrap() / rho)), ("f64", 1e-12, 1e-7)];
            let laws = [(kerr.replace(';', "\n"), false), (typed(&kerr), false), (kerr.replace(';', "\n"), true)];
            for ((law, separated), (precision, tolerance, bound)) in
                laws.iter().flat_map(|law| bits.map(|bits| (law, bits)))
            {
                let method = match precision {
                    _ if !separated => format!("method = \"dormand-prince\"\ntolerance = {tolerance}"),
                    "f32" => "method = \"separated\"\nscaled_step = 0.02".to_owned(),
                    _ => "method = \"separated\"\nscaled_step = 0.005".to_owned(),
                };
                if k == 2 && precision == "f32" {
                    continue;
                }
                // The disk is open at other radii, so that later crossings are visible as well.
                let scene = scene(&format!(
                    "[image]\nsize = [1, 1]\n[camera]\nposition = {:?}\nlook_at = {:?}\nup = [0, 0, 1]\nfov = 1\nobserver = \"static\"\n\
                     redshift = true\n[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 200 }}\n{method}\nprecision = \"{precision}\"\n\
                     max_segments = 20000\n[materials.m]\nkind = \"accretion\"\ntemperature = 9000\n[[objects]]\nshape = \"disk\"\n\
                     material = \"m\"\nnormal = [0, 0, 1]\nradius = {}\ninner_radius = {}\n",
                    origin.to_array(),
                    (origin + way).to_array(),
                    1.05 * rho,
                    0.95 * rho
                ));
                let picture = rendered(&scene);
                let Some(Plane::Vector(position)) = picture.band.layer(Layer::Position) else { panic!("no positions") };
                let off = (f64::from(position[0][0]) - number(0)).hypot(f64::from(position[1][0]) - number(1)) / rho;
                println!("{} crossing {k}: off by {off:e} of {bound:e}", row[0]);
                assert!(off < bound, "{} crossing {k}: off by {off:e}", row[0]);
                if words[3] == "none" {
                    continue;
                }
                let g = f64::from(shifts(&picture)[0]);
                let kelvin = 9000.0 * number(3) * (number(4) / most).powf(0.25);
                let (color, luminance) = black_body::color(kelvin);
                let told = color * (luminance - black_body::color(9000.0).1).exp();
                let found = DVec3::from_array([0, 1, 2].map(|channel| f64::from(picture.band.color[channel][0])));
                println!("g {g} for {}, colour {found} for {told}", number(3));
                assert!((g / number(3) - 1.0).abs() < 1e-4, "{} crossing {k}: g is {g}", row[0]);
                assert!(found.distance(told) < 2e-3 * told.length(), "{} crossing {k}: {found}, not {told}", row[0]);
            }
        }
    }
}

/// Checks that a translucent disk is visible at each crossing of a ray, attenuated by the earlier crossings and with a
/// separate redshift. All schedules agree, and so does ray splitting.
#[test]
fn light_of_translucent_discs_adds_up() {
    const OPACITY: f64 = 0.3;
    for row in rows(include_str!("tables/disc_crossings.tsv")) {
        let (spin, origin, way): (f64, _, _) = (row[1].parse().unwrap(), vector(row[2]), vector(row[3]));
        let crossings: Vec<Vec<Option<f64>>> =
            row[4].split("; ").map(|crossing| crossing.split(' ').map(|word| word.parse().ok()).collect()).collect();
        let rho = |crossing: &Vec<Option<f64>>| crossing[0].unwrap().hypot(crossing[1].unwrap());
        let outer = crossings.iter().map(rho).fold(0.0, f64::max);
        let text = format!(
            "[image]\nsize = [1, 1]\n[camera]\nposition = {:?}\nlook_at = {:?}\nup = [0, 0, 1]\nfov = 1\nobserver = \"static\"\n\
             redshift = true\n[law]\nkind = \"kerr-newman\"\nspin = {spin}\n[rays]\nbounding_sphere = {{ radius = 200 }}\nmethod = \"separated\"\n\
             scaled_step = 0.05\nmax_segments = 1000\n[materials.m]\nkind = \"accretion\"\n\
             temperature = 9000\nopacity = {OPACITY}\n[[objects]]\nshape = \"disk\"\nmaterial = \"m\"\nnormal = [0, 0, 1]\n\
             radius = {}\ninner_radius = 0.5\n",
            origin.to_array(),
            (origin + way).to_array(),
            1.01 * outer
        );
        let scene = scene(&text);
        let most = hottest(spin);
        let (mut left, mut told, mut orders) = (OPACITY, DVec3::ZERO, Vec::new());
        for crossing in &crossings {
            if let (Some(g), Some(flux)) = (crossing[3], crossing[4]) {
                let (color, luminance) = black_body::color(9000.0 * g * (flux / most).powf(0.25));
                orders.push(left * (luminance - black_body::color(9000.0).1).exp());
                told += orders[orders.len() - 1] * color;
            } else {
                orders.push(0.0);
            }
            left *= 1.0 - OPACITY;
        }
        let seen = [Schedule::Whole, Schedule::Segment].map(|schedule| {
            let options = ProgramOptions { schedule, layers: vec![Layer::ImageOrder], ..ProgramOptions::default() };
            let settings = RenderSettings { options, ..RenderSettings::default() };
            let picture = Renderer::new(&gpu(), &scene, settings).unwrap().render().unwrap();
            let Some(Plane::Vector(seen)) = picture.band.layer(Layer::ImageOrder) else { panic!("no image orders") };
            orders.resize(3, 0.0);
            // A few third crossings are so far out and grazing that errors of 32 bits are visible.
            for ((seen, told), bound) in seen.iter().zip(&orders).zip([2e-3, 2e-3, 2e-2]) {
                let off = (f64::from(seen[0]) - told).abs();
                assert!(off <= bound * told, "{} {schedule:?}: {seen:?} for {orders:?}", row[0]);
            }
            DVec3::from_array([0, 1, 2].map(|channel| f64::from(picture.band.color[channel][0])))
        });
        println!("{}, {} crossings: {} for {told}", row[0], crossings.len(), seen[0]);
        assert!(seen[0].distance(told) < 2e-3 * told.length(), "{}: {}, not {told}", row[0], seen[0]);
        assert!(seen[0] == seen[1], "{}", row[0]);
    }
}
