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
    meaning: "how the surface reflects, transmits or emits light",
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

/// What is known of a surface whatever its color.
#[derive(Debug, Clone)]
#[allow(clippy::struct_excessive_bools)] // facts, each by itself
pub struct Facts<'a> {
    /// Its WGSL part: a path whose last name is in those of its functions, and in capitals its code.
    pub part: &'static str,
    /// Do rays continue from it?
    pub continues: bool,
    /// Does a ray that continues from it leave the path that the law alone would take it along?
    pub deflects: bool,
    /// The part of a ray's light that is its own, where rays end on it; the rest comes straight from behind.
    pub opacity: f64,
    /// Where rays go on from it, if the user says so.
    pub fan: Option<&'a [FanRay]>,
    /// Do paths aim at it, if it emits?
    pub is_aimed_at: bool,
    /// Does a ray go on in a direction that is drawn from a lobe?
    pub has_lobe: bool,
    /// Does it give back light about the mirror's direction?
    pub is_glossy: bool,
    /// Does its color follow from a temperature?
    pub has_temperature: bool,
    /// Does it go round as matter does by its law, and not rest?
    pub orbits: bool,
    /// Is it lit by the scene's lights?
    pub is_lit: bool,
}

impl Facts<'_> {
    /// Returns the facts of a surface on which rays end, by this WGSL part.
    #[must_use]
    pub fn ending(part: &'static str) -> Self {
        Self {
            part,
            continues: false,
            deflects: false,
            opacity: 1.0,
            fan: None,
            is_aimed_at: true,
            has_lobe: false,
            is_glossy: false,
            has_temperature: false,
            orbits: false,
            is_lit: false,
        }
    }

    /// Returns the facts of a surface that rays continue from, by this WGSL part.
    #[must_use]
    pub fn scattering(part: &'static str) -> Self {
        Self { continues: true, deflects: true, ..Self::ending(part) }
    }
}

/// How a surface answers light.
pub trait Surface: fmt::Debug + Send + Sync + Same {
    /// What is known of it whatever its color.
    fn facts(&self) -> Facts<'_>;

    /// The members of `Material` that are its own.
    fn values(&self) -> Row {
        Row::new()
    }

    /// What it radiates by itself, on the mean; `color` is that of its pattern.
    fn emission(&self, _color: DVec3) -> DVec3 {
        DVec3::ZERO
    }

    /// The part of the light that it gives back at most, where its pattern has this color.
    fn albedo(&self, _color: DVec3) -> DVec3 {
        DVec3::ZERO
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
