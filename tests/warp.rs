//! Tests the claims of the manual about the view from inside a warp bubble.

use std::path::Path;

use bentray::guide::pages;
use bentray::render::{RenderSettings, Status, trace_pixels};
use bentray::scene::Scene;

use crate::support::gpu;

/// An Alcubierre warp bubble, of speed 0.9 and radius 1.
struct Bubble {
    sigma: f64,
}

const SPEED: f64 = 0.9;

impl Bubble {
    /// Returns the shape f at the distance s from the center, and its slope.
    fn shape(&self, s: f64) -> (f64, f64) {
        let (out, back) = ((self.sigma * (s + 1.0)).tanh(), (self.sigma * (s - 1.0)).tanh());
        let whole = 2.0 * self.sigma.tanh();
        ((out - back) / whole, self.sigma * (back * back - out * out) / whole)
    }

    /// Returns the rates of the position in the bubble's plane, (x − vt, y), and of the wave vector: the Hamiltonian
    /// equations of H = |p| + v f pₓ, which is `−p_t` of the light.
    fn rates(&self, [x, y, px, py]: [f64; 4]) -> [f64; 4] {
        let (s, p) = (x.hypot(y), px.hypot(py));
        let (shape, slope) = self.shape(s);
        let pull = -SPEED * px * slope / s;
        [px / p - (1.0 - shape) * SPEED, py / p, pull * x, pull * y]
    }

    /// Returns the direction of the star that an observer near the center sees at `seen`, both in radians from straight
    /// ahead, and the energy of its light there divided by that outside. Integrates backward along the ray by the classical
    /// Runge–Kutta method, whose error at this step is below 1e-8.
    fn star(&self, seen: f64) -> (f64, f64) {
        let step = -0.02 / self.sigma;
        let mut at = [0.01, 0.0, -seen.cos(), -seen.sin()];
        let moved = |at: [f64; 4], by: f64, rate: [f64; 4]| std::array::from_fn(|k| at[k] + by * rate[k]);
        // Beyond this 1 − f is less than 1e-17.
        while at[0].hypot(at[1]) < 1.0 + 20.0 / self.sigma {
            let first = self.rates(at);
            let second = self.rates(moved(at, step / 2.0, first));
            let third = self.rates(moved(at, step / 2.0, second));
            let last = self.rates(moved(at, step, third));
            at = std::array::from_fn(|k| at[k] + step / 6.0 * (first[k] + 2.0 * (second[k] + third[k]) + last[k]));
        }
        ((-at[3]).atan2(-at[2]), 1.0 / at[2].hypot(at[3]))
    }
}

#[test]
fn the_guides_angles_are_those_of_light() {
    let page = pages().find(|page| page.name == "warp_bubble").unwrap();
    let cells = |line: &str| line.split('|').filter_map(|cell| cell.trim().strip_suffix('°')?.parse().ok()).collect();
    let rows: Vec<Vec<f64>> = page.text.lines().map(cells).filter(|row: &Vec<f64>| row.len() == 3).collect();
    assert!(rows.len() > 5, "{rows:?}");
    for row in rows {
        for (sigma, shown) in [(4.0, row[1]), (40.0, row[2])] {
            let (star, energy) = Bubble { sigma }.star(row[0].to_radians());
            let off = star.to_degrees() - shown;
            assert!(off.abs() < 0.0051, "{sigma}: seen at {}°, {shown}° is off by {off}", row[0]);
            // The camera is slightly ahead of the center, where 1 − f is 2e-6 at σ = 4.
            let kept = 1.0 + SPEED * (1.0 - Bubble { sigma }.shape(0.01).0) * row[0].to_radians().cos();
            assert!((energy * kept - (1.0 + SPEED * star.cos())).abs() < 1e-7, "{sigma}: {energy} from {star}");
        }
    }
    let scenes = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/spacetimes/README.md"));
    let words = scenes.unwrap().replace('\n', " ");
    let star = |seen: f64| Bubble { sigma: 4.0 }.star(seen.to_radians()).0.to_degrees();
    assert!(words.contains(&format!("seen 40° off the axis is at {:.1}°", star(40.0))));
    assert!(words.contains(&format!("the star {:.1}° off it is seen at 20°", 180.0 - star(160.0))));
}

/// The shipped scene shows each star where an independent integration finds it.
#[test]
fn the_scene_shows_stars_where_their_light_comes_from() {
    let gpu = gpu();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/spacetimes/warp_bubble.toml");
    let pixels: Vec<[u32; 2]> = [320, 373, 400, 427, 480, 530].map(|x| [x, 240]).into();
    for (sigma, look, sign) in [(4.0, "[1,0,0]", 1.0), (4.0, "[-1,0,0]", -1.0), (40.0, "[1,0,0]", 1.0)] {
        let keys = [
            format!("camera.look_at={look}"),
            format!("law.parameters.sigma={sigma}"),
            "rays.method=\"dormand-prince\"".to_owned(),
            "rays.tolerance=1e-6".to_owned(),
        ];
        let scene = Scene::load(&path, &keys.map(|key| key.parse().unwrap())).unwrap();
        let (ends, _) = trace_pixels(&gpu, &scene, &RenderSettings::default(), &pixels).unwrap();
        for ([x, y], end) in pixels.iter().zip(ends) {
            assert_eq!(end.status, Status::Escaped);
            // An equidistant fisheye: 90° from the center to the rim, which is 240 pixels away.
            let pixel = (f64::from(*x) + 0.5 - 320.0).hypot(f64::from(*y) + 0.5 - 240.0);
            let off_axis = (pixel / 240.0 * 90.0).to_radians();
            let seen = if sign > 0.0 { off_axis } else { std::f64::consts::PI - off_axis };
            let (star, _) = Bubble { sigma }.star(seen);
            let found = end.v[1].hypot(end.v[2]).atan2(end.v[0]);
            // The bounds of other line elements: 2e-5 rad, and 40 roundings, which the wall multiplies by at most 2.
            assert!((found - star).abs() < 4e-5, "{sigma}: seen at {seen}, {found} instead of {star}");
        }
    }
}
