//! Construction of scenes in code, without TOML.
//!
//! *Practice.* [`Scene::new`] creates an empty scene with a law; its fields are public, and additions correspond to the tables of a file.
//! Unlike files, scenes in code are not checked, except for the indices of added items.

use std::sync::Arc;

use glam::DVec3;

use super::throat::add_throat;
use super::{
    Accelerate, Bound, Image, Output, Precision, Rays, SamplePattern, Scene, Segment, Sky, Splitting, Tonemap,
    Transform,
};
use crate::model::control::embedded;
use crate::model::medium::D_LINE;
use crate::model::method::TOLERANT;
use crate::model::{Interior, Law, Material, Medium, Object, Pattern, Shape, Substance, Surface};

impl Scene {
    /// Creates a scene with a law, a black sky, and a bounding sphere of `radius` scene units around the origin, beyond which rays have
    /// escaped.
    ///
    /// The radius must be above 0. The image has 800×600 pixels. The method keeps a tolerance of 10⁻⁵ and uses closed forms where they
    /// exist. A render also needs a camera, such as [`Camera::look_at`](super::Camera::look_at) creates; without one it returns an error.
    ///
    /// # Examples
    ///
    /// ```
    /// use std::sync::Arc;
    ///
    /// use bentray::glam::{DVec3, dvec3};
    /// use bentray::model::{camera::Pinhole, law::RoundHole, material::Phong, shape::Sphere};
    /// use bentray::scene::{Camera, Pattern, Scene, Transform};
    ///
    /// let mut scene = Scene::new(RoundHole::new(1.0, DVec3::ZERO), 50.0);
    /// scene.image.size = [320, 200];
    /// scene.camera = Camera::look_at(dvec3(0.0, 2.0, 15.0), DVec3::ZERO, DVec3::Y, Arc::new(Pinhole { fov: 50.0 }));
    /// let red = scene.add_material("red", Pattern::Constant(dvec3(0.8, 0.1, 0.1)), Phong::default());
    /// scene.add_object(Sphere, Transform::new(DVec3::ONE, DVec3::ZERO, dvec3(3.0, 0.0, -4.0)), red);
    /// assert_eq!(scene.objects[0].bounds(), (dvec3(2.0, -1.0, -5.0), dvec3(4.0, 1.0, -3.0)));
    /// ```
    #[must_use]
    pub fn new(law: impl Law, radius: f64) -> Self {
        let (mut materials, mut objects) = (Vec::new(), Vec::new());
        add_throat(&law, &mut materials, &mut objects);
        Self {
            units: None,
            image: Image::default(),
            camera: None,
            law: Arc::new(law),
            absorption: None,
            rays: Rays::new(radius),
            sky: Sky::Color(DVec3::ZERO),
            sky_other_side: None,
            stars: [None, None],
            output: Output::default(),
            materials,
            objects,
            lights: Vec::new(),
            volumes: Vec::new(),
            radiation: None,
            occlusion: None,
            animation: None,
            pictures: Vec::new(),
            left_out: Vec::new(),
        }
    }

    /// Adds a material, and returns its index for [`Scene::add_object`].
    ///
    /// `name` appears in messages. `color` is linear red, green and blue, each usually from 0 to 1; `surface` defines how the material
    /// scatters light.
    pub fn add_material(&mut self, name: &str, color: Pattern, surface: impl Surface) -> usize {
        self.materials.push(Material { name: name.to_owned(), color, surface: Arc::new(surface) });
        self.materials.len() - 1
    }

    /// Adds an opaque object: a shape with a placement and a material, whose index [`Scene::add_material`] has returned. [`Scene::new`] has
    /// an example.
    ///
    /// # Panics
    ///
    /// Panics if there is no material of this index.
    pub fn add_object(&mut self, shape: impl Shape, transform: Transform, material: usize) {
        assert!(material < self.materials.len(), "there is no material {material}");
        self.objects.push(Object::new(Arc::new(shape), transform, Substance::Opaque(material)));
    }

    /// Adds a transparent object: a shape with a placement, filled with a medium. Where interiors overlap, the one with the higher priority
    /// wins. A mesh that overlaps itself becomes several objects.
    ///
    /// # Panics
    ///
    /// Panics if the shape cannot have an interior: see [`Shape::refuses_interior`].
    ///
    /// # Examples
    ///
    /// ```
    /// use bentray::glam::{DVec3, dvec3};
    /// use bentray::model::{law::Straight, medium::Constant, shape::Sphere};
    /// use bentray::scene::{Scene, Transform};
    ///
    /// let mut scene = Scene::new(Straight, 20.0);
    /// let glass = Constant { n: 1.5 };
    /// scene.add_interior(Sphere, Transform::new(DVec3::splat(2.0), DVec3::ZERO, dvec3(0.0, 1.0, 0.0)), glass, 0);
    /// assert!(scene.objects[0].interior().is_some());
    /// ```
    pub fn add_interior(&mut self, shape: impl Shape, transform: Transform, medium: impl Medium, priority: u32) {
        assert_eq!(shape.refuses_interior(), None, "light cannot go through this shape");
        let substance = Substance::TransparentShadows(Interior { priority, ..Interior::new(Arc::new(medium)) });
        self.objects.extend(Object::new(Arc::new(shape), transform, substance).solids());
    }
}

impl Default for Image {
    /// Returns an image of 800×600 pixels with one sample per pixel.
    fn default() -> Self {
        Self { size: [800, 600], samples: 1, sampler: SamplePattern::MultiJittered, adaptive: None, footprints: false }
    }
}

impl Default for Output {
    /// Returns an output of unchanged radiance in eight bits.
    fn default() -> Self {
        Self { exposure: 0.0, tonemap: Tonemap::None, bits: 8, glare: 0.0, clamp: None }
    }
}

impl Rays {
    /// Returns the settings of a scene file that specifies only the radius of the bounding sphere, with a tolerance of 10⁻⁵.
    #[must_use]
    pub fn new(radius: f64) -> Self {
        Self {
            method: TOLERANT,
            control: embedded::with(1e-5, 0.3),
            auto: None,
            segment: Segment::Arc { tolerance: 1e-4 * radius },
            max_segments: 1000,
            bounding_sphere: Bound { center: DVec3::ZERO, radius },
            max_parameter: None,
            sky_at_infinity: false,
            precision: Precision::Single,
            closed_forms: true,
            leaps: true,
            max_splits: Splitting::Enumerated(4),
            acceleration: Accelerate::Auto,
            path_tracing: None,
            wavelength: D_LINE,
        }
    }
}
