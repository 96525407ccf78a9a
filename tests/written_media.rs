//! Media that a scene specifies by formulas and samples, in whole programs.

use bentray::render::{RenderSettings, Status, Traced, trace};
use glam::DVec3;

use crate::support::{gpu, scene};

fn ends(index: &str, rays_table: &str, rays: &[[f64; 6]]) -> Vec<Traced> {
    let text = format!("[law]\nkind = \"medium\"\nindex = {index}\n[rays]\n{rays_table}\n");
    trace(&gpu(), &scene(&text), &RenderSettings::default(), rays).unwrap_or_else(|error| panic!("{error}")).0
}

fn parallel_rays() -> Vec<[f64; 6]> {
    (0..40).map(|i| [-0.9, 0.02 * f64::from(i) - 0.4, 0.1, 1.0, 0.0, 0.0]).collect()
}

fn furthest(a: &[Traced], b: &[Traced]) -> f64 {
    assert!(a.iter().zip(b).all(|(a, b)| a.status == b.status && a.status == Status::Escaped), "{:?}", a[0].status);
    a.iter().zip(b).map(|(a, b)| a.distance_to(b).max(a.angle_to(b))).fold(0.0, f64::max)
}

/// Compares a built-in lens with a formula for it around a different center, in both precisions and by several methods.
#[test]
fn a_lens_as_a_formula_is_the_lens() {
    let lens = "{ kind = \"luneburg\", radius = 1, center = [0.1, 0.2, 0] }";
    let formula = "{ kind = \"expression\", n = \"sqrt(2 - r^2)\", center = [0.1, 0.2, 0] }";
    for (rays, bound) in [
        ("method = \"dormand-prince\"\ntolerance = 1e-6", 1e-5),
        ("method = \"rk4\"\nscaled_step = 0.02", 1e-5),
        ("method = \"dormand-prince\"\ntolerance = 1e-12\nprecision = \"f64\"", 1e-11),
    ] {
        let rays = format!("{rays}\nmax_segments = 4000\nbounding_sphere = {{ radius = 1 }}");
        let [a, b] = [lens, formula].map(|index| ends(index, &rays, &parallel_rays()));
        let off = furthest(&a, &b);
        println!("{rays}: {off:e}");
        assert!(off <= bound, "{rays}: {off:e}");
    }
}

/// In a Maxwell fisheye every ray from p moves on a circle through −a² p/|p|².
#[test]
fn a_fisheye_as_a_formula_has_circles() {
    let index = "{ kind = \"expression\", n = \"2 / (1 + (x^2 + y^2 + z^2) / 4)\", scale = 1 }";
    let p = DVec3::new(-1.0, 0.5, 0.25);
    let across = -4.0 * p / p.length_squared() - p;
    let directions: Vec<DVec3> = (0..24)
        .map(|i| {
            let (s, c) = (0.26 * f64::from(i)).sin_cos();
            DVec3::new(c, s, 0.3).normalize()
        })
        .collect();
    let rays: Vec<[f64; 6]> = directions.iter().map(|d| [p.x, p.y, p.z, d.x, d.y, d.z]).collect();
    let table = "method = \"dormand-prince\"\ntolerance = 1e-6\nmax_segments = 4000\nbounding_sphere = { radius = 30 }\nmax_parameter = 1";
    for (d, end) in directions.iter().zip(ends(index, table, &rays)) {
        assert_eq!(end.status, Status::Ended);
        let to_center = across.reject_from_normalized(*d).normalize();
        let radius = across.length_squared() / (2.0 * to_center.dot(across));
        let way = DVec3::from(end.x) - p;
        assert!(way.length() > 0.5, "{way}");
        let off_plane = way.dot(d.cross(to_center)).abs();
        let off_circle = ((way - radius * to_center).length() - radius).abs();
        assert!(off_plane < 1e-5 && off_circle < 1e-5, "{off_plane:e}, {off_circle:e} of {radius}");
    }
}

/// If a formula has no value, or none above 0, rays fail by every method, and none ends otherwise. A ray so close to such a
/// point that no step is short enough stalls.
#[test]
fn rays_fail_where_there_is_no_index() {
    let methods = [
        "method = \"euler\"\nscaled_step = 0.1",
        "method = \"rk4\"\nscaled_step = 0.1",
        "method = \"snell\"\nscaled_step = 0.01",
        "method = \"rk4-doubling\"\ntolerance = 1e-5",
        "method = \"rk4-doubling\"\ndoubling = \"paper\"\ntolerance = 1e-5",
        "method = \"bogacki-shampine\"\ntolerance = 1e-5",
        "method = \"dormand-prince\"\ntolerance = 1e-5",
        "method = \"dormand-prince\"\ntolerance = 1e-9\nprecision = \"f64\"",
    ];
    // Rays that run into the border at x = 1, rays along it, and one that starts beyond.
    let mut rays: Vec<[f64; 6]> = (0..8).map(|i| [-1.0, 0.1 * f64::from(i), 0.0, 1.0, 0.0, 0.0]).collect();
    rays.push([2.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    for method in methods {
        for n in ["1.5 + 0 * x + 0.2 * sqrt(1 - x)", "1.5 + 0.1 * (1 - x)^1.5"] {
            let index = format!("{{ kind = \"expression\", n = \"{n}\" }}");
            let table = format!("{method}\nmax_segments = 4000\nbounding_sphere = {{ radius = 5 }}");
            for (ray, end) in rays.iter().zip(ends(&index, &table, &rays)) {
                let is_seen = matches!(end.status, Status::Failed | Status::Stalled);
                assert!(is_seen, "{n} by {method}: {ray:?} ends at {:?}: {:?}", end.x, end.status);
            }
        }
    }
    // A value below 0 is not a valid index.
    let steep = "{ kind = \"expression\", n = \"1.01 - exp(4 * x)\" }";
    for end in ends(
        steep,
        "method = \"rk4\"\nscaled_step = 0.2\nmax_segments = 400\nbounding_sphere = { radius = 5 }",
        &rays[8..],
    ) {
        assert_eq!(end.status, Status::Failed);
    }
}

/// A smooth index and its samples: the slopes of the spline are central differences, so that path errors are of second
/// order in the cell size, or less if errors of both signs cancel.
#[test]
fn samples_of_an_index_bend_as_it_does() {
    let folder = tempfile::tempdir().unwrap();
    let index = |q: DVec3| 1.0 + 0.2 * (-q.length_squared()).exp();
    let formula = "{ kind = \"expression\", n = \"1 + 0.2 * exp(-r^2)\" }";
    let table = "method = \"rk4\"\nscaled_step = 0.05\nmax_segments = 4000\nbounding_sphere = { radius = 2 }";
    let mut errors = Vec::new();
    for count in [17_u32, 33] {
        let place = |i: u32| 5.0 * f64::from(i) / f64::from(count - 1) - 2.5;
        let mut bytes = Vec::new();
        for k in 0..count {
            for j in 0..count {
                for i in 0..count {
                    bytes.extend((index(DVec3::new(place(i), place(j), place(k))) as f32).to_le_bytes());
                }
            }
        }
        let file = folder.path().join(format!("{count}.raw"));
        std::fs::write(&file, &bytes).unwrap();
        let grid = format!(
            "{{ kind = \"grid\", file = \"{}\", size = [{count}, {count}, {count}], type = \"f32\", \
             min = [-2.5, -2.5, -2.5], max = [2.5, 2.5, 2.5] }}",
            file.display()
        );
        let [a, b] = [formula, &grid].map(|index| ends(index, table, &parallel_rays()));
        errors.push(furthest(&a, &b));
    }
    println!("samples: {errors:?}");
    assert!(errors[1] < 4e-3 && errors[1] < errors[0] / 3.5, "{errors:?}");
}
