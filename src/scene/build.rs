//! Scenes made in code, without TOML.
//!
//! *Practice.* [`Scene::new`] is an empty scene under a law; its fields are public, and what is added is what a file could say. Nothing
//! is checked that a file would be checked for, but that indices are those of what was added.

use std::sync::Arc;

use glam::DVec3;

use super::throat::add_throat;
use super::{
    Accelerate, Bound, Branches, Image, Output, Precision, Rays, SamplePattern, Scene, Segment, Sky, Tonemap, Transform,
};
use crate::model::control::embedded;
use crate::model::medium::D_LINE;
use crate::model::method::TOLERANT;
use crate::model::{Interior, Law, Material, Medium, Object, Pattern, Shape, Substance, Surface};

impl Scene {
    /// Nothing but a law, before a black sky, in a bounding sphere of `radius` scene units about the origin: rays that leave it have
    /// escaped. Rays are followed at a tolerance of 10⁻⁵, by closed forms where there are some. A picture needs a camera too, such as
    /// [`Camera::looking`](super::Camera::looking) makes: without one rendering is an error.
    #[must_use]
    pub fn new(law: impl Law, radius: f64) -> Self {
        let (mut materials, mut objects) = (Vec::new(), Vec::new());
        add_throat(&law, &mut materials, &mut objects);
        Self {
            image: Image::default(),
            camera: None,
            law: Arc::new(law),
            filter: None,
            rays: Rays::new(radius),
            sky: Sky::Color(DVec3::ZERO),
            beyond: None,
            output: Output::default(),
            materials,
            objects,
            lights: Vec::new(),
            occlusion: None,
            animation: None,
            pictures: Vec::new(),
            left_out: Vec::new(),
        }
    }

    /// Adds a material; what comes back is its index, for [`Scene::add`].
    pub fn add_material(&mut self, name: &str, color: Pattern, surface: impl Surface) -> usize {
        self.materials.push(Material { name: name.to_owned(), color, surface: Arc::new(surface) });
        self.materials.len() - 1
    }

    /// Adds a shape in a place, made of a material.
    ///
    /// # Panics
    ///
    /// Where there is no such material.
    pub fn add(&mut self, shape: impl Shape, transform: Transform, material: usize) {
        assert!(material < self.materials.len(), "there is no material {material}");
        self.objects.push(Object::new(Arc::new(shape), transform, Substance::Opaque(material)));
    }

    /// Adds a shape in a place, filled with a medium that light goes through. Of interiors that overlap, the one of the higher
    /// priority is there. A mesh that overlaps itself becomes several objects.
    ///
    /// # Panics
    ///
    /// If light cannot go through the shape: see [`Shape::refuses_interior`].
    pub fn add_interior(&mut self, shape: impl Shape, transform: Transform, medium: impl Medium, priority: u32) {
        assert_eq!(shape.refuses_interior(), None, "light cannot go through this shape");
        let substance = Substance::Clear(Interior { priority, ..Interior::new(Arc::new(medium)) });
        self.objects.extend(Object::new(Arc::new(shape), transform, substance).solids());
    }
}

impl Default for Image {
    /// 800×600 pixels of one sample.
    fn default() -> Self {
        Self { size: [800, 600], samples: 1, pattern: SamplePattern::MultiJittered, adaptive: None, footprints: false }
    }
}

impl Default for Output {
    /// As it is, in eight bits.
    fn default() -> Self {
        Self { exposure: 0.0, tonemap: Tonemap::None, bits: 8, clamp: None }
    }
}

impl Rays {
    /// As a scene file has it that says no more than the radius of the bounding sphere, at a tolerance of 10⁻⁵.
    #[must_use]
    pub fn new(radius: f64) -> Self {
        Self {
            method: TOLERANT,
            control: embedded::with(1e-5, 0.3),
            auto: None,
            segment: Segment::Arc { tolerance: 1e-4 * radius },
            max_segments: 1000,
            bound: Bound { center: DVec3::ZERO, radius },
            length: None,
            asymptotic: false,
            precision: Precision::Single,
            closed_forms: true,
            leaps: true,
            branches: Branches::Enumerated(4),
            accelerate: Accelerate::Auto,
            paths: None,
            wavelength: D_LINE,
        }
    }
}
