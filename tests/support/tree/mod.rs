//! A ray tracer on the CPU, in 64 bits: the reference for images with ray splitting.
//!
//! *Theory.* Whitted's recursion: if a surface both reflects and transmits, both rays are followed, with the weights R, the
//! Fresnel reflectance, and 1 − R. L/n² is constant along a ray, so light counts by (n at the camera)² / (n at the end)².
//! Paths through media are closed forms or Taylor series; nothing here is shared with the shaders.
//!
//! *Practice.* It supports straight space with interiors, and the shapes, media and skies that a test has needed; others make
//! it panic. [`Tracer::render`] is the image at one sample per pixel; [`Tracer::next`] and [`Tracer::cross`] follow one ray.

mod interface;
mod light;
mod meet;
mod path;
mod series;
mod solid;

use bentray::model::camera::Pinhole;
use bentray::model::law::Straight;
use bentray::model::material::Mirror;
use bentray::model::medium::Constant;
use bentray::scene::{Medium, Scene, Splitting, Substance};
use glam::DVec3;

pub use interface::Interface;
use meet::{Next, Standing, on_line, on_path};
use path::{Path, index};
use solid::Body;

/// The number of surfaces along one path after which it is cut.
const MOST_MEETINGS: u32 = 1000;

/// A ray in the scene.
#[derive(Debug, Clone)]
pub struct Ray {
    /// The position.
    pub x: DVec3,
    /// The unit direction.
    pub d: DVec3,
    /// The transparent objects that contain it, in the order in which it has entered them.
    inside: Vec<usize>,
    /// The objects whose surface it is on.
    on: Vec<usize>,
}

/// The end of a ray.
#[derive(Debug, Clone)]
pub enum Met {
    /// A surface.
    Surface(Meeting),
    /// The sky, in this direction.
    Sky(DVec3),
    /// Nothing: the ray never ends.
    Lost,
}

/// A ray's arrival at a surface.
#[derive(Debug, Clone)]
pub struct Meeting {
    /// The ray at the surface, before it crosses.
    pub ray: Ray,
    /// The object; an opaque one, if there is one at this point.
    pub object: usize,
    /// The outward unit normal.
    pub normal: DVec3,
}

/// A scene that is ready to be traced.
pub struct Tracer<'s> {
    scene: &'s Scene,
    bodies: Vec<Body>,
}

impl<'s> Tracer<'s> {
    /// Creates a tracer; panics if the scene has unsupported features.
    pub fn new(scene: &'s Scene) -> Self {
        assert!(scene.law.downcast::<Straight>().is_some(), "the tracer supports no other law");
        assert!(scene.rays.max_parameter.is_none(), "the tracer does not limit the path parameter");
        Self { scene, bodies: scene.objects.iter().map(Body::new).collect() }
    }

    /// Returns the image, row by row from the top: the radiance at the center of each pixel.
    pub fn render(&self) -> Vec<DVec3> {
        let [width, height] = self.scene.image.size;
        assert_eq!(self.scene.image.samples, 1, "the tracer takes one sample");
        (0..width * height).map(|i| self.pixel(i % width, i / width)).collect()
    }

    /// Returns the radiance at the center of one pixel.
    pub fn pixel(&self, column: u32, row: u32) -> DVec3 {
        let camera = self.scene.camera.as_ref().expect("a camera");
        let Pinhole { fov } = camera.projection.downcast().expect("the tracer only supports the pinhole camera");
        let [width, height] = self.scene.image.size.map(f64::from);
        // Upward and to the right from the center, in units of half the image height.
        let right = (2.0 * f64::from(column) + 1.0 - width) / height;
        let up = 1.0 - (2.0 * f64::from(row) + 1.0) / height;
        let half = (0.5 * fov).to_radians().tan();
        let d = camera.forward + half * (right * camera.right + up * camera.up);
        self.seen(camera.position, d.normalize())
    }

    /// Returns the radiance that arrives at `x` against the unit vector `d`.
    pub fn seen(&self, x: DVec3, d: DVec3) -> DVec3 {
        let Splitting::Enumerated(branchings) = self.scene.rays.max_splits else {
            panic!("the tracer does not support random branches")
        };
        let ray = self.ray(x, d);
        self.medium_index(&ray).powi(2) * self.radiance(ray, branchings)
    }

    /// Returns a ray that starts at `x`. Of the objects around it, it has last entered the one whose surface is nearest behind.
    pub fn ray(&self, x: DVec3, d: DVec3) -> Ray {
        let around = |k: &usize| {
            self.scene.objects[*k].interior().is_some() && self.bodies[*k].level(self.bodies[*k].own(x)) < 0.0
        };
        let mut inside: Vec<usize> = (0..self.bodies.len()).filter(around).collect();
        let behind = |k: &usize| self.bodies[*k].span(x, -d).map_or(f64::INFINITY, |[_, leaves]| leaves);
        inside.sort_by(|a, b| behind(b).total_cmp(&behind(a)));
        Ray { x, d, inside, on: Vec::new() }
    }

    /// Returns the object that the ray is in: among those of the highest priority, the one that it has entered last.
    fn current(&self, ray: &Ray) -> Option<usize> {
        ray.inside.iter().copied().max_by_key(|k| self.scene.objects[*k].interior().map(|interior| interior.priority))
    }

    fn medium(&self, ray: &Ray) -> &dyn Medium {
        let interior = self.current(ray).and_then(|k| self.scene.objects[k].interior());
        interior.map_or(&Constant { n: 1.0 }, |interior| &*interior.medium)
    }

    /// Returns the index at the position of the ray, 1 outside everything.
    pub fn medium_index(&self, ray: &Ray) -> f64 {
        index(self.medium(ray), ray.x)
    }

    /// Returns the next surface of the ray, even if it is hidden in the medium.
    pub fn next(&self, ray: &Ray) -> Met {
        let mut path = Path::new(self.medium(ray), ray.x, ray.d);
        let standings: Vec<Standing> = (0..self.bodies.len()).map(|k| self.standing(ray, k, &mut path)).collect();
        let bound = self.scene.rays.bounding_sphere;
        let found = match path {
            Path::Line { x, d } => {
                // Rays end at the bounding sphere.
                let within = |x: DVec3| x.distance(bound.center) <= bound.radius * (1.0 + 1e-12);
                on_line(x, d, bound.radius, &standings, within)
            }
            _ => on_path(&mut path, bound.radius, &standings),
        };
        let (surfaces, (x, d)) = match found {
            Next::Surfaces(surfaces, point) => (surfaces, point),
            Next::Nothing if ray.inside.is_empty() => return Met::Sky(ray.d),
            Next::Nothing | Next::Lost => return Met::Lost,
        };
        let opaque = surfaces.iter().find(|k| self.scene.objects[**k].material().is_some());
        let object = *opaque.unwrap_or(&surfaces[0]);
        let normal = self.bodies[object].normal(x);
        Met::Surface(Meeting { ray: Ray { x, d, inside: ray.inside.clone(), on: surfaces }, object, normal })
    }

    fn standing(&self, ray: &Ray, k: usize, path: &mut Path) -> Standing {
        let body = self.bodies[k];
        let on = ray.on.contains(&k);
        let inside = if self.scene.objects[k].interior().is_some() {
            ray.inside.contains(&k)
        } else if on {
            // If an ingoing spiral is treated as an outgoing one, the path does not begin along the ray.
            path.at(0.0).1.dot(body.normal(ray.x)) < 0.0
        } else {
            body.level(body.own(ray.x)) < 0.0
        };
        Standing { body, inside, on }
    }

    /// Returns the effect of the surfaces of transparent objects on a ray that has met them, and the resulting rays: the reflected one, and
    /// the one across.
    pub fn cross(&self, meeting: &Meeting) -> (Interface, Ray, Ray) {
        let here = &meeting.ray;
        let mut across = here.clone();
        let left = |k: &usize| across.on.contains(k);
        let entered: Vec<usize> = across.on.iter().copied().filter(|k| !across.inside.contains(k)).collect();
        let mut inside: Vec<usize> = across.inside.iter().copied().filter(|k| !left(k)).collect();
        inside.extend(entered);
        across.inside = inside;
        let interface = if self.current(here) == self.current(&across) {
            Interface::Matched
        } else {
            Interface::new(self.medium_index(here), self.medium_index(&across), here.d, meeting.normal)
        };
        let mut back = here.clone();
        match interface {
            Interface::Matched => {}
            Interface::Total { reflected } => back.d = reflected,
            Interface::Split { reflected, transmitted, .. } => (back.d, across.d) = (reflected, transmitted),
        }
        (interface, back, across)
    }

    /// Returns `true` if no opaque object is on a line of this length from a point on a side of `own`. All bodies are convex.
    fn is_clear(&self, own: usize, x: DVec3, d: DVec3, distance: f64) -> bool {
        let within = |t: f64| t > 0.0 && t < distance;
        let blocks = |k: usize| self.bodies[k].span(x, d).is_some_and(|ends| ends.into_iter().any(within));
        let opaque = |k: usize| k != own && self.scene.objects[k].material().is_some();
        !(0..self.bodies.len()).any(|k| opaque(k) && blocks(k))
    }

    /// Returns L/n² against the ray; a path that would branch more than `branchings` times is cut.
    fn radiance(&self, mut ray: Ray, branchings: u32) -> DVec3 {
        let mut weight = DVec3::ONE;
        for _ in 0..MOST_MEETINGS {
            let meeting = match self.next(&ray) {
                Met::Sky(d) => return weight * light::sky(self.scene, d),
                Met::Lost => return DVec3::ZERO,
                Met::Surface(meeting) => meeting,
            };
            let Substance::Opaque(material) = self.scene.objects[meeting.object].substance else {
                let (interface, back, across) = self.cross(&meeting);
                ray = match interface {
                    Interface::Matched => across,
                    Interface::Total { .. } => back,
                    Interface::Split { .. } if branchings == 0 => return DVec3::ZERO,
                    Interface::Split { reflectance, .. } => {
                        let [back, across] = [back, across].map(|ray| self.radiance(ray, branchings - 1));
                        return weight * (reflectance * back + (1.0 - reflectance) * across);
                    }
                };
                continue;
            };
            let material = &self.scene.materials[material];
            let Meeting { ray: Ray { x, d, .. }, normal, object } = meeting;
            let color = light::color(self.scene, material, self.bodies[object].uv(x));
            if material.surface.downcast::<Mirror>().is_some() {
                weight *= color;
                ray = Ray { d: interface::mirrored(d, normal), ..meeting.ray };
                continue;
            }
            let facing = if d.dot(normal) > 0.0 { -normal } else { normal };
            let lit = light::Lit { x, normal: facing, view: -d };
            let reaches = |distance: f64, to_light: DVec3| self.is_clear(object, x, to_light, distance);
            let seen = light::radiance(self.scene, material, color, lit, reaches);
            return weight * seen / self.medium_index(&meeting.ray).powi(2);
        }
        DVec3::ZERO
    }
}
