//! Materials: how a surface answers light. The contract, and the table of kinds.
//!
//! *Theory.* A kind whose rays end on the surface gives `radiance_KIND` in WGSL, one from which they continue `scatter_KIND`. All read
//! the same record, `Material`, each its own members.
//!
//! *Practice.* [`KINDS`] names each kind once. Adding one is a WGSL file, a file here and a line of that table.

mod accretion;
mod blackbody;
mod emissive;
mod fan;
mod glossy;
mod mirror;
mod pattern;
mod phong;
mod throat;

use std::fmt;
use std::sync::Arc;

use glam::DVec3;

use super::same::same;
use super::{Row, Same};
use crate::assets::{FanRay, Files, Picture};
use crate::document::reader::TableReader;
use crate::document::{self, Kinds};

pub use accretion::Accretion;
pub use blackbody::Blackbody;
pub use emissive::Emissive;
pub use fan::Fan;
pub use glossy::Glossy;
pub use mirror::Mirror;
pub use pattern::Pattern;
pub use phong::Phong;
pub use throat::Throat;

/// Reads the colour that a material uses, and what it does with it; none if it cannot be used.
type Read = fn(&TableReader, &mut Files) -> Option<(Pattern, Arc<dyn Surface>)>;
type Kind = document::Kind<Read>;

/// Every kind of material. Adding one is a line here.
pub static KINDS: Kinds<Read> = Kinds {
    table: "materials.NAME",
    chooser: "kind",
    meaning: "how it answers light",
    example: None,
    all: &[&phong::KIND, &emissive::KIND, &blackbody::KIND, &accretion::KIND, &mirror::KIND, &glossy::KIND, &fan::KIND],
};

/// `[materials.NAME]`.
#[derive(Debug, Clone)]
pub struct Material {
    /// The name in the file.
    pub name: String,
    /// The colour that its kind uses, over the surface.
    pub color: Pattern,
    /// How it answers light.
    pub surface: Arc<dyn Surface>,
}

impl PartialEq for Material {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.color == other.color && *self.surface == *other.surface
    }
}

/// How a surface answers light.
pub trait Surface: fmt::Debug + Send + Sync + Same {
    /// Its WGSL part: a path whose last name is in those of its functions, and in capitals its code.
    fn part(&self) -> &'static str;

    /// The members of `Material` that are its own.
    fn values(&self) -> Row {
        Row::new()
    }

    /// Do rays continue from it?
    fn continues(&self) -> bool {
        false
    }

    /// Returns `true` if a ray that continues from it leaves the path that the law alone would take it along.
    fn deflects(&self) -> bool {
        self.continues()
    }

    /// The part of a ray's light that is its own, where rays end on it; the rest comes straight from behind.
    fn opacity(&self) -> f64 {
        1.0
    }

    /// Where rays go on from it, if the user says so.
    fn fan(&self) -> Option<&[FanRay]> {
        None
    }

    /// What it radiates by itself, on the mean; `color` is that of its pattern.
    fn emission(&self, _color: DVec3) -> DVec3 {
        DVec3::ZERO
    }

    /// Do paths aim at it, if it emits?
    fn is_aimed_at(&self) -> bool {
        true
    }

    /// The part of the light that it gives back at most, where its pattern has this colour.
    fn albedo(&self, color: DVec3) -> DVec3;

    /// Does a ray go on in a direction that is drawn from a lobe?
    fn has_lobe(&self) -> bool {
        false
    }

    /// Does it give back light about the mirror's direction?
    fn is_glossy(&self) -> bool {
        false
    }

    /// Does its colour follow from a temperature?
    fn has_temperature(&self) -> bool {
        false
    }

    /// Does it go round as matter does by its law, and not rest?
    fn orbits(&self) -> bool {
        false
    }

    /// Is it lit by the scene's lights?
    fn is_lit(&self) -> bool {
        false
    }
}

same!(Surface);

/// The names of all materials, and those that can be used, both in the order of the file. On `paths` none may give back more light than
/// it gets.
pub(crate) fn read<'a>(root: &TableReader<'_, 'a>, files: &mut Files, paths: bool) -> (Vec<&'a str>, Vec<Material>) {
    let Some(table) = root.subtable("materials", "materials") else {
        return (Vec::new(), Vec::new());
    };
    let names = table.entries().map(|(name, _)| name).collect();
    let materials = table.entries().filter_map(|(name, node)| {
        let table = table.reader.open("materials.NAME", node)?;
        let read = KINDS.chosen(&table).and_then(|read| read(&table, files));
        let material = read.map(|(color, surface)| Material { name: name.to_owned(), color, surface });
        if let Some(material) = material.as_ref().filter(|_| paths) {
            check_albedo(&table, material, &files.pictures());
        }
        table.finish();
        material
    });
    (names, materials.collect())
}

/// A surface that gave back more light than it gets would make a path's light grow without end.
fn check_albedo(table: &TableReader, material: &Material, pictures: &[Picture]) {
    let albedo = material.surface.albedo(material.color.largest(pictures)).max_element();
    if albedo > 1.0 + 1e-9 {
        let problem = format!("this surface gives back up to {albedo:.4} of the light that it gets");
        table.fault(&[], problem, "on paths its parts must add up to 1 or less in every channel");
    }
}
