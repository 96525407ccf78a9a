//! The light from surfaces and the sky, in 64 bits.

use bentray::model::material::Phong;
use bentray::scene::{LightSource, Material, Pattern, Picture, Scene, Shadows, Sky};
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// Returns the color of a material at (u, v).
pub fn color(scene: &Scene, material: &Material, uv: DVec2) -> DVec3 {
    shown(scene, &material.color, uv)
}

fn shown(scene: &Scene, pattern: &Pattern, uv: DVec2) -> DVec3 {
    match pattern {
        Pattern::Constant(color) => *color,
        Pattern::Checker { colors, repeat } => {
            let cell = (uv * *repeat).floor();
            colors[(cell.x + cell.y).rem_euclid(2.0) as usize]
        }
        Pattern::Picture { picture, repeat } => {
            // Images begin at the top left, and v at the bottom.
            let place = DVec2::new(uv.x, 1.0 - uv.y) * *repeat;
            sample(&scene.pictures[*picture], place - place.floor())
        }
        // Only meshes have vertex colors; on all other shapes they are white.
        Pattern::VertexColors(pattern) => shown(scene, pattern, uv),
    }
}

/// A point of a surface, seen from a side.
#[derive(Debug, Clone, Copy)]
pub struct Lit {
    /// The point.
    pub x: DVec3,
    /// The unit normal, on the viewer's side.
    pub normal: DVec3,
    /// The direction to the viewer.
    pub view: DVec3,
}

/// Returns the radiance toward the viewer; `reaches` gets the direction and distance of each light that casts shadows.
pub fn radiance(
    scene: &Scene,
    material: &Material,
    color: DVec3,
    at: Lit,
    reaches: impl Fn(f64, DVec3) -> bool,
) -> DVec3 {
    let Some(phong) = material.surface.downcast::<Phong>() else { return color };
    let Phong { ambient, specular, shininess, emission } = *phong;
    let Lit { x, normal, view } = at;
    let lit = scene.lights.iter().map(|light| {
        let (distance, to_light) = match light.source {
            LightSource::Point(position) => (position.distance(x), (position - x).normalize()),
            LightSource::Directional(direction) => (f64::INFINITY, -direction),
        };
        let facing = normal.dot(to_light);
        if facing <= 0.0 || (light.shadows == Shadows::Straight && !reaches(distance, to_light)) {
            return DVec3::ZERO;
        }
        let halfway = (to_light + view).normalize();
        let strength = if light.falls { distance.powi(-2) } else { 1.0 };
        strength * light.color * (facing * color + normal.dot(halfway).max(1e-6).powf(shininess) * specular)
    });
    emission + ambient * color + lit.sum::<DVec3>()
}

/// Returns the radiance from infinity, from the direction `d`.
pub fn sky(scene: &Scene, d: DVec3) -> DVec3 {
    match scene.sky {
        Sky::Color(color) => color,
        Sky::Transparent => DVec3::ZERO,
        Sky::Equirectangular(picture, intensity, rotation) => {
            let d = rotation.transpose() * d;
            // −z is at the center, +x to its right, +y at the top.
            let picture = &scene.pictures[picture];
            let (u, v) = (0.5 + d.x.atan2(-d.z) / (2.0 * PI), 0.5 - d.y.atan2(d.x.hypot(d.z)) / PI);
            let half = 0.5 / f64::from(picture.size[1]);
            intensity * sample(picture, DVec2::new(u, v.clamp(half, 1.0 - half)))
        }
        Sky::Faces(..) => panic!("the tracer does not support a sky of six faces"),
    }
}

/// Interpolates between the four pixels around a position in [0, 1]² from the top left; the image repeats.
fn sample(picture: &Picture, place: DVec2) -> DVec3 {
    let [width, height] = picture.size.map(i64::from);
    let p = place * DVec2::new(width as f64, height as f64) - 0.5;
    let (base, part) = (p.floor(), p - p.floor());
    let pixel = |dx: i64, dy: i64| {
        let (column, row) = ((base.x as i64 + dx).rem_euclid(width), (base.y as i64 + dy).rem_euclid(height));
        DVec3::from(picture.pixels[(row * width + column) as usize].map(f64::from))
    };
    pixel(0, 0).lerp(pixel(1, 0), part.x).lerp(pixel(0, 1).lerp(pixel(1, 1), part.x), part.y)
}
