//! The import of lights from `KHR_lights_punctual`.

use std::f64::consts::PI;

use glam::{DVec3, Vec3};

use super::Extent;
use super::text::{Left, color, vector};
use crate::assets::json::extensions::scene::khr_lights_punctual::Type;
use crate::assets::json::validation::Checked::Valid;
use crate::assets::{Gltf, Placed};

/// Returns the tables of the lights and the positions of point lights. If there are no lights and no surface emits, a light is added next
/// to the viewer at `eye`.
pub(super) fn lights(
    file: &Gltf,
    nodes: &[Placed],
    extent: &Extent,
    eye: DVec3,
    shines: bool,
    left: &mut Left,
) -> (String, Vec<DVec3>) {
    let (mut text, mut places) = (String::new(), Vec::new());
    for placed in nodes {
        let index = placed.node.extensions.as_ref().and_then(|all| all.khr_lights_punctual.as_ref());
        let Some(light) = index.and_then(|index| file.root.get(index.light)) else { continue };
        let names = [&placed.node.name, &light.name].into_iter().flatten().next();
        let name = names.cloned().unwrap_or_else(|| format!("node {}", placed.number));
        let radiance = Vec3::from(light.color).as_dvec3() * f64::from(light.intensity) / PI;
        match light.type_ {
            Valid(Type::Directional) => match placed.world.matrix3.z_axis.try_normalize() {
                Some(back) => text += &directional(-back, radiance),
                None => left.out("lights without a direction", &name),
            },
            Valid(kind @ (Type::Point | Type::Spot)) => {
                if kind == Type::Spot {
                    left.out("the cones of spot lights, which become point lights", &name);
                }
                if light.range.is_some() {
                    left.out("the ranges of lights, which become unlimited", &name);
                }
                let position = placed.world.translation;
                places.push(position);
                text.extend([format!(
                    "[[lights]]\nkind = \"point\"\nposition = {}\ncolor = {}\nfalloff = \"inverse-square\"\nshadows = \"straight-rays\"\n\n",
                    vector(position),
                    color(radiance)
                )]);
            }
            _ => left.out("lights of an unknown type", &name),
        }
    }
    if text.is_empty() && !shines {
        left.added("a light, because the file has none");
        let towards = (extent.center() - eye).try_normalize().unwrap_or(DVec3::NEG_Z);
        let side = towards.cross(DVec3::Y).try_normalize().unwrap_or(DVec3::X);
        let from_above_left = towards + 0.5 * side + 0.5 * DVec3::NEG_Y;
        text += &directional(from_above_left.try_normalize().unwrap_or(towards), DVec3::ONE);
    }
    (text, places)
}

fn directional(direction: DVec3, radiance: DVec3) -> String {
    let (direction, color) = (vector(direction), color(radiance));
    format!(
        "[[lights]]\nkind = \"directional\"\ndirection = {direction}\ncolor = {color}\nshadows = \"straight-rays\"\n\n"
    )
}
