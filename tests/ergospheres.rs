//! The redshift of light that is seen from inside an ergosphere, where its energy may be negative, and of light from near a
//! horizon, compared with Carter's equations and the constants of motion at the camera.

#![allow(clippy::many_single_char_names)] // the letters of the formulas

use bentray::program::Layer;
use bentray::render::{Plane, Rendering};
use glam::{DMat4, DVec2, DVec3, DVec4};

use crate::shifts::{rendered, shifts};
use crate::spacetimes::typed;
use crate::support::scene;

/// A black hole of mass 1 around the z axis, in Kerr–Schild coordinates.
struct Hole {
    spin: f64,
}

/// Light of frequency 1 at the camera, traced into the past: `K_t`, `K_φ` and Carter's constant, K = Q + (L − aE)².
struct Light {
    energy: f64,
    turning: f64,
    carter: f64,
}

impl Hole {
    fn radius(&self, x: DVec3) -> f64 {
        let k = 0.5 * (x.length_squared() - self.spin.powi(2));
        (k + k.hypot(self.spin * x.z)).sqrt()
    }

    fn metric(&self, x: DVec3) -> DMat4 {
        let (a, r) = (self.spin, self.radius(x));
        let f = 2.0 * r.powi(3) / (r.powi(4) + (a * x.z).powi(2));
        let s = r * r + a * a;
        let l = DVec4::new((r * x.x + a * x.y) / s, (r * x.y - a * x.x) / s, x.z / r, 1.0);
        DMat4::from_diagonal(DVec4::new(1.0, 1.0, 1.0, -1.0)) + f * DMat4::from_cols(l.x * l, l.y * l, l.z * l, l.w * l)
    }

    /// Returns the light that a zero-angular-momentum or static observer at x sees along d, for axes right, up and forward.
    fn light(&self, x: DVec3, axes: [DVec3; 3], d: DVec3, rests: bool) -> Light {
        let (a, g) = (self.spin, self.metric(x));
        let dot = |a: DVec4, b: DVec4| a.dot(g * b);
        let around = DVec4::new(-x.y, x.x, 0.0, 0.0);
        let dragged = if rests { 0.0 } else { -dot(around, DVec4::W) / dot(around, around) };
        let way = DVec4::W + dragged * around;
        let u = way / (-dot(way, way)).sqrt();
        let mut k = -u;
        let mut found: Vec<DVec4> = Vec::new();
        for (axis, part) in [(axes[2], d.z), (axes[1], d.y), (axes[0], d.x)] {
            let mut e = axis.extend(0.0);
            e += dot(u, e) * u;
            for &other in &found {
                e -= dot(other, e) * other;
            }
            found.push(e / dot(e, e).sqrt());
            k += part * found[found.len() - 1];
        }
        let lowered = g * k;
        let (energy, turning) = (lowered.w, around.dot(lowered));
        // ∂θ at constant Kerr–Schild φ: ρ = √(r² + a²) sin θ and z = r cos θ.
        let (r, rho) = (self.radius(x), DVec2::new(x.x, x.y).length());
        let (s, cos) = ((r * r + a * a).sqrt(), x.z / r);
        let sin = rho / s;
        let polar = DVec3::new(x.x / rho * s * cos, x.y / rho * s * cos, -r * sin).dot(lowered.truncate());
        // Into the past L has the opposite sign.
        let carter = polar.powi(2) + (a * energy * sin + turning / sin).powi(2);
        Light { energy, turning, carter }
    }

    /// Returns the frequencies for matter in the equator at r, of light from smaller and from larger radii.
    fn frequencies(&self, light: &Light, r: f64) -> [f64; 2] {
        let a = self.spin;
        let [clock, turning, inwards] = self.matter(r);
        let delta = r * r - 2.0 * r + a * a;
        let lift = light.energy * (r * r + a * a) + a * light.turning;
        let radial = (lift * lift - delta * light.carter).max(0.0).sqrt() / delta;
        [-1.0, 1.0].map(|sign| clock * light.energy + turning * light.turning + inwards * sign * radial)
    }

    /// Returns uᵗ, uᵠ and uʳ in Boyer–Lindquist coordinates: on a circular orbit, and inside the ISCO on a fall with its E and L.
    fn matter(&self, r: f64) -> [f64; 3] {
        let a = self.spin;
        let orbit = |r: f64| {
            let turning = 1.0 / (r.powf(1.5) + a);
            let clock = (1.0 + a * r.powf(-1.5)) / (1.0 - 3.0 / r + 2.0 * a * r.powf(-1.5)).sqrt();
            [clock, clock * turning, 0.0]
        };
        let edge = self.innermost_stable();
        if r >= edge {
            return orbit(r);
        }
        let [clock, turning, _] = orbit(edge);
        let energy = clock * (1.0 - 2.0 / edge) + 2.0 * a / edge * turning;
        let momentum = -2.0 * a / edge * clock + (edge * edge + a * a + 2.0 * a * a / edge) * turning;
        let delta = r * r - 2.0 * r + a * a;
        let lift = energy * (r * r + a * a) - a * momentum;
        let fall = (lift * lift - delta * (r * r + (momentum - a * energy).powi(2))).max(0.0).sqrt() / (r * r);
        let clock = (a * (momentum - a * energy) + (r * r + a * a) * lift / delta) / (r * r);
        [clock, (momentum - a * energy + a * lift / delta) / (r * r), -fall]
    }

    /// Bardeen, Press and Teukolsky 1972, eq. 2.21.
    fn innermost_stable(&self) -> f64 {
        let a = self.spin;
        let z1 = 1.0 + (1.0 - a * a).cbrt() * ((1.0 + a).cbrt() + (1.0 - a).cbrt());
        let z2 = (3.0 * a * a + z1 * z1).sqrt();
        3.0 + z2 - ((3.0 - z1) * (3.0 + z1 + 2.0 * z2)).sqrt()
    }
}

/// Returns the number of pixels that see the disk, the number that see it by light of negative energy, and the largest relative error of g.
fn compared(picture: &Rendering, hole: &Hole, light: impl Fn(usize) -> Light, from: f64) -> (usize, usize, f64) {
    let Some(Plane::Vector([x, y, _])) = picture.band.layer(Layer::Position) else { panic!("no position layer") };
    let (mut seen, mut negative, mut worst) = (0, 0, 0.0_f64);
    for (i, shift) in shifts(picture).iter().enumerate().filter(|(_, shift)| **shift != 0.0) {
        let r = (f64::from(x[i]).powi(2) + f64::from(y[i]).powi(2) - hole.spin.powi(2)).sqrt();
        // Pixels of the sky are not on the disk.
        if !(from..13.0).contains(&r) {
            continue;
        }
        let light = light(i);
        let told = hole.frequencies(&light, r).map(|frequency| 1.0 / frequency);
        let off = told.map(|told| (f64::from(*shift) / told - 1.0).abs()).into_iter().fold(f64::INFINITY, f64::min);
        seen += 1;
        negative += usize::from(light.energy < 0.0);
        worst = worst.max(off);
    }
    (seen, negative, worst)
}

const METHODS: [(&str, &str); 4] = [
    ("f32", "method = \"dormand-prince\"\ntolerance = 1e-6"),
    ("f32", "method = \"separated\"\nscaled_step = 0.05"),
    ("f64", "method = \"dormand-prince\"\ntolerance = 1e-9"),
    ("f64", "method = \"separated\"\nscaled_step = 0.02"),
];

/// Checks disks of orbiting and of infalling matter, seen from inside the ergosphere
/// and from far away, with the black hole's law and with its line element.
#[test]
fn light_of_any_energy_is_shifted_as_its_constants_say() {
    let far = DVec3::new(29.544_232_590_366_242, 0.0, 5.209_445_330_007_912);
    // The last value is the minimum number of pixels that see the disk by light of negative energy.
    for (spin, position, inside, least) in [
        (0.998, DVec3::new(1.6, 0.0, 0.35), true, 40),
        (0.9, DVec3::new(1.6, 1.0, -0.3), true, 0),
        (0.998, far, false, 0),
    ] {
        let hole = Hole { spin };
        let forward = -position.normalize();
        let right = forward.cross(DVec3::Z).normalize();
        let axes = [right, right.cross(forward), forward];
        let (camera, size, fov) = if inside { ("fisheye", [24, 24], 300.0) } else { ("pinhole", [24, 18], 20.0_f64) };
        let light = |i: usize| {
            let [column, row] = [i % size[0], i / size[0]].map(|k| k as f64);
            let p = DVec2::new((2.0 * column + 1.0) / size[0] as f64 - 1.0, 1.0 - (2.0 * row + 1.0) / size[1] as f64);
            let d = if inside {
                let (sin, cos) = (p.length() * fov / 2.0).to_radians().sin_cos();
                (sin * p.normalize()).extend(cos)
            } else {
                let half = (fov / 2.0).to_radians().tan();
                DVec3::new(half * p.x * size[0] as f64 / size[1] as f64, half * p.y, 1.0).normalize()
            };
            hole.light(position, axes, d, !inside)
        };
        let horizon = 1.0 + (1.0 - spin * spin).sqrt();
        let written = typed(&format!("kind=\"kerr-newman\";spin={spin}"));
        for (law, precision, method) in METHODS.into_iter().flat_map(|(precision, method)| {
            let laws = [format!("kind = \"kerr-newman\"\nspin = {spin}"), written.clone()];
            let count = if method.contains("separated") { 1 } else { 2 };
            laws.into_iter().take(count).map(move |law| (law, precision, method))
        }) {
            let scene = scene(&format!(
                "[image]\nsize = {size:?}\nsamples = 1\n[camera]\nkind = \"{camera}\"\nposition = {:?}\nlook_at = {:?}\nup = [0, 0, 1]\n\
                 fov = {fov}\nobserver = \"{}\"\nredshift = true\n[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 60 }}\n{method}\n\
                 precision = \"{precision}\"\nmax_segments = 1000\n[materials.m]\nkind = \"accretion\"\n[[objects]]\n\
                 shape = \"disk\"\nmaterial = \"m\"\nnormal = [0, 0, 1]\nradius = 12\ninner_radius = 1\n",
                position.to_array(),
                (position + forward).to_array(),
                if inside { "zamo" } else { "static" },
            ));
            let picture = rendered(&scene);
            // Orbiting matter is interpolated linearly between 4096 radii. For infalling matter a part of K counts that is
            // known up to a factor, and its source is as small as Δ, which is at least 0.02.
            let falling = if precision == "f32" { 1e-3 } else { 1e-4 };
            for (what, from, bound) in [("orbits", hole.innermost_stable(), 5e-5), ("falls", horizon + 0.1, falling)] {
                let (seen, negative, worst) = compared(&picture, &hole, light, from);
                println!("{spin} {position} {law} {precision} {method}: {what} {seen} {negative} {worst:e}");
                assert!(seen > 20 && negative >= least, "{seen} pixels for {what}, {negative} by negative energy");
                assert!(worst < bound, "{spin} {position} {law} {precision} {method}, {what}: off by {worst:e}");
            }
        }
    }
}
