//! Moving objects, seen where they were when their light left them, compared with closed forms and objects at rest.

use bentray::program::{Layer, ProgramOptions, Schedule};
use bentray::render::{RenderSettings, Renderer, Status, trace};
use bentray::scene::Observer;
use glam::{DMat3, DVec3};

use crate::oracle::{rows, vector};
use crate::shaders::Random;
use crate::shifts::{rendered, shifts};
use crate::support::{gpu, scene};

const WHEN: f64 = 7.0;
const START: DVec3 = DVec3::new(-2.0, 0.5, 1.0);
const VELOCITY: DVec3 = DVec3::new(0.6, -0.3, 0.2);
const RADIUS: f64 = 1.5;

fn sphere_passing(precision: &str, camera: &str) -> String {
    format!(
        "[image]\nsize = [1, 1]\n[camera]\nposition = [0, 0, 9]\n{camera}\ntime = {WHEN}\n[law]\nkind = \"straight\"\n[rays]\n\
         bounding_sphere = {{ radius = 40 }}\nprecision = \"{precision}\"\n[materials.a]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n\
         [[objects]]\nshape = \"sphere\"\nmaterial = \"a\"\ncenter = {:?}\nradius = {RADIUS}\nvelocity = {:?}\n\
         [[objects]]\nshape = \"sphere\"\nmaterial = \"a\"\ncenter = [0, 6, 0]\n",
        START.to_array(),
        VELOCITY.to_array()
    )
}

/// Returns the time back at which the ray from x along d meets the passing sphere: |x + d τ − (start + w (t − τ))| = r, in closed form.
fn meeting(x: DVec3, d: DVec3) -> Option<f64> {
    let (a, b) = (x - START - WHEN * VELOCITY, d + VELOCITY);
    let (bb, ab) = (b.length_squared(), a.dot(b));
    let root = (ab * ab - bb * (a.length_squared() - RADIUS * RADIUS)).sqrt();
    // Some rays begin inside.
    [-root, root].map(|root| (root - ab) / bb).into_iter().find(|tau| *tau > 0.0)
}

/// Checks in flat space which rays meet a passing sphere, where and when; a sphere at rest next to it is met as usual.
#[test]
fn passing_spheres_are_met_where_they_were() {
    let mut random = Random::new(19);
    let rays: Vec<[f64; 6]> = (0..4000)
        .map(|_| {
            let (x, d) = (random.direction() * random.log(4.0, 9.0), random.direction());
            let d = (d - 0.8 * x.normalize()).normalize();
            [x.x, x.y, x.z, d.x, d.y, d.z].map(|x| f64::from(x as f32))
        })
        .collect();
    for (precision, bound) in [("f32", 1e-4), ("f64", 1e-11)] {
        let scene = scene(&sphere_passing(precision, ""));
        let (ends, _) = trace(&gpu(), &scene, &RenderSettings::default(), &rays).unwrap();
        let mut met = 0;
        for (ray, end) in rays.iter().zip(&ends) {
            let (x, d) = (DVec3::new(ray[0], ray[1], ray[2]), DVec3::new(ray[3], ray[4], ray[5]));
            let still = {
                let (a, dd) = (x - DVec3::new(0.0, 6.0, 0.0), d.length_squared());
                let root = (a.dot(d).powi(2) - dd * (a.length_squared() - 1.0)).sqrt();
                [-root, root].map(|root| (root - a.dot(d)) / dd).into_iter().find(|tau| *tau > 0.0)
            };
            let told = [meeting(x, d).map(|tau| (0, tau)), still.map(|tau| (1, tau))];
            let told = told.into_iter().flatten().min_by(|a, b| a.1.total_cmp(&b.1));
            // Rounding decides whether rays graze.
            let sine = told.map_or(1.0, |(object, tau)| {
                let middle = if object == 0 { START + (WHEN - tau) * VELOCITY } else { DVec3::new(0.0, 6.0, 0.0) };
                let relative = if object == 0 { d + VELOCITY } else { d };
                ((x + tau * d - middle).normalize().dot(relative.normalize())).abs()
            });
            if sine < 1e-2 {
                continue;
            }
            let found = end.object.filter(|_| end.status == Status::Hit).map(|object| (object, end.tau));
            assert_eq!(found.map(|(object, _)| object as usize), told.map(|(object, _)| object), "{ray:?}: {end:?}");
            let Some(((_, found), (object, told))) = found.zip(told) else { continue };
            let off = (found - told).abs().max(DVec3::from(end.x).distance(x + told * d));
            assert!(off * sine < bound, "{precision}, {ray:?}: off by {off:e}");
            met += usize::from(object == 0);
        }
        assert!(met > 200, "{met}");
    }
}

/// Checks the frequency of light by the Doppler formula, from passing objects, and from objects at rest for a moving observer.
#[test]
fn passing_light_is_shifted_by_its_speed() {
    let eye = DVec3::new(0.0, 0.0, 9.0);
    let tau = {
        // Aimed at the earlier center of the sphere: |middle(t − τ) − eye| = τ.
        let (a, b) = (START + WHEN * VELOCITY - eye, -VELOCITY);
        let (half, rest) = (a.dot(b), 1.0 - b.length_squared());
        (half + (half * half + rest * a.length_squared()).sqrt()) / rest
    };
    let ahead = START + (WHEN - tau) * VELOCITY;
    let d = (ahead - eye).normalize();
    let stretch = 1.0 / (1.0 - VELOCITY.length_squared()).sqrt();
    let camera = format!("look_at = {:?}\nfov = 1\nobserver = \"static\"", ahead.to_array());
    let found = f64::from(shifts(&rendered(&scene(&sphere_passing("f32", &camera))))[0]);
    let told = 1.0 / (stretch * (1.0 + VELOCITY.dot(d)));
    assert!((found / told - 1.0).abs() < 1e-5, "{found} for {told}");
}

/// Around a rotating black hole a small orbiting sphere is met at a ray's crossing of the equator if both arrive together;
/// its redshift agrees with series. At another time it is not met there.
#[test]
fn orbiting_spheres_are_met_in_time() {
    for row in rows(include_str!("tables/disc_crossings.tsv")) {
        let (spin, origin, way): (f64, _, _) = (row[1].parse().unwrap(), vector(row[2]), vector(row[3]));
        let [first, ..] = row[4].split("; ").collect::<Vec<_>>()[..] else { panic!() };
        let told: Vec<f64> = first.split(' ').filter_map(|word| word.parse().ok()).collect();
        if told.len() < 5 {
            continue;
        }
        let crossing = DVec3::new(told[0], told[1], 0.0);
        let head = |method: &str, objects: &str| {
            format!(
                "[image]\nsize = [1, 1]\n[camera]\nposition = {:?}\nlook_at = {:?}\nup = [0, 0, 1]\nfov = 1\nobserver = \"static\"\ntime = 13\n\
                 [law]\nkind = \"kerr-newman\"\nspin = {spin}\n[rays]\nbounding_sphere = {{ radius = 200 }}\n{method}\nprecision = \"f64\"\n\
                 max_segments = 20000\n[materials.a]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n{objects}",
                origin.to_array(),
                (origin + way).to_array()
            )
        };
        let fine = "method = \"dormand-prince\"\ntolerance = 1e-10";
        let disk =
            "[[objects]]\nshape = \"disk\"\nnormal = [0, 0, 1]\nradius = 150\ninner_radius = 1.5\nmaterial = \"a\"\n";
        let still = scene(&head(fine, disk));
        let law = still.law.clone();
        let pixel = bentray::render::trace_pixels(&gpu(), &still, &RenderSettings::default(), &[[0, 0]]).unwrap().0;
        assert!(DVec3::from(pixel[0].x).distance(crossing) < 1e-5, "{:?} for {crossing}", pixel[0].x);
        let u = law.observer(Observer::ProgradeOrbit, crossing).unwrap().unwrap();
        let turning = u.truncate().dot(DVec3::Z.cross(crossing)) / (u.w * crossing.length_squared());
        // The sphere reaches the crossing a time of 13 − τ after its initial position.
        let placed = |late: f64| {
            let turn = DMat3::from_rotation_z(-turning * (13.0 - pixel[0].tau + late));
            let center = turn * crossing;
            format!(
                "[[objects]]\nshape = \"sphere\"\nradius = 0.01\nmaterial = \"a\"\norbit = \"prograde\"\ncenter = {:?}\n",
                center.to_array()
            )
        };
        for method in [fine, "method = \"separated\"\nscaled_step = 0.02", "method = \"rk4\"\nscaled_step = 0.05"] {
            let picture = rendered(&scene(&head(method, &placed(0.0))));
            let g = f64::from(shifts(&picture)[0]);
            assert!((g / told[3] - 1.0).abs() < 5e-3, "{} by {method}: g is {g}, not {}", row[0], told[3]);
            let missed = rendered(&scene(&head(method, &placed(1.0))));
            assert!(
                missed.totals.count(Status::Hit) == 0 && picture.totals.count(Status::Hit) == 1,
                "{} by {method}",
                row[0]
            );
        }
    }
}

/// At another time an orbiting object is at its rotated position, and an object at rest on its orbit is where it was;
/// images are identical in all schedules, with every structure.
#[test]
fn moving_objects_are_the_same_in_all_schedules() {
    let text = |time: f64, turned: f64| {
        let objects: Vec<String> = (0..9)
            .map(|k| {
                let (sine, cosine) = (0.7 * f64::from(k)).sin_cos();
                let size = ["radius = 0.8", "size = [1, 2, 1]", "radius = 0.6\nheight = 2", "radius = 1", "size = [1.6, 2]"];
                format!(
                    "[[objects]]\nshape = \"{}\"\nmaterial = \"a\"\n{}\ncenter = [{}, {}, 0.3]\nrotate = [0, 0, {}]\norbit = 0.05\n",
                    ["sphere", "box", "cylinder", "disk", "plane"][k as usize % 5],
                    size[k as usize % 5],
                    7.0 * cosine,
                    7.0 * sine,
                    (0.05 * turned).to_degrees()
                )
            })
            .collect();
        format!(
            "[image]\nsize = [48, 32]\n[camera]\nposition = [0, -20, 7]\nup = [0, 0, 1]\nfov = 50\ntime = {time}\n[law]\nkind = \"kerr-newman\"\n\
             spin = 0.8\n[rays]\nbounding_sphere = {{ radius = 40 }}\nmethod = \"dormand-prince\"\ntolerance = 1e-5\n[materials.a]\n\
             kind = \"emissive\"\ncolor = {{ checker = [[1, 0, 0], [0, 1, 0]] }}\n[materials.b]\nkind = \"mirror\"\n{}[[objects]]\nshape = \"sphere\"\n\
             center = [0, 9, 3]\nmaterial = \"b\"\n[sky]\ncolor = [0.2, 0.3, 0.4]\n",
            objects.concat()
        )
    };
    let picture = |text: &str, schedule: Schedule, accelerate: &str| {
        let scene = scene(&text.replace("[rays]\n", &format!("[rays]\nacceleration = \"{accelerate}\"\n")));
        let options = ProgramOptions { schedule, layers: vec![Layer::Position], ..ProgramOptions::default() };
        let settings = RenderSettings { options, ..RenderSettings::default() };
        Renderer::new(&gpu(), &scene, settings).unwrap().render().unwrap()
    };
    let now = text(11.0, 0.0);
    let told = picture(&now, Schedule::Whole, "auto");
    for (schedule, accelerate) in [
        (Schedule::Fused, "auto"),
        (Schedule::Segment, "auto"),
        (Schedule::Paper, "auto"),
        (Schedule::Whole, "none"),
        (Schedule::Segment, "bvh"),
        (Schedule::Fused, "grid"),
    ] {
        let other = picture(&now, schedule, accelerate);
        assert!(other.band.color == told.band.color, "{schedule:?} with {accelerate}");
    }
    let turned = picture(&text(0.0, 11.0), Schedule::Whole, "auto");
    let differ = |k: &usize| (told.band.color[0][*k] - turned.band.color[0][*k]).abs() > 0.02;
    let wrong = (0..48 * 32).filter(differ).count();
    assert!(wrong <= 4, "{wrong} pixels differ");
    let seen = told.band.color[1].iter().filter(|green| **green > 0.9).count();
    assert!(seen > 20, "{seen}");
}
