//! The throat of a wormhole as surfaces of the scene.

use std::sync::Arc;

use glam::DVec3;

use super::Transform;
use crate::model::material::Throat;
use crate::model::shape::Sphere;
use crate::model::{Law, Material, Object, Pattern, Substance};

/// Adds a sphere around each mouth, after the scene's objects, if the law has a throat.
pub fn add_throat(law: &dyn Law, materials: &mut Vec<Material>, objects: &mut Vec<Object>) {
    let Some(throat) = law.facts().throat else { return };
    let color = Pattern::Constant(DVec3::ONE);
    materials.push(Material { name: "throat".to_owned(), color, surface: Arc::new(Throat) });
    let substance = Substance::Opaque(materials.len() - 1);
    for mouth in throat.mouths {
        let transform = Transform::new(DVec3::splat(throat.radius), DVec3::ZERO, mouth);
        objects.push(Object::new(Arc::new(Sphere), transform, substance.clone()));
    }
}
