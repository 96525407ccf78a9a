//! Materials, which define how a surface reflects and emits light: the contract and the table of kinds.
//!
//! *Theory.* If rays end on a surface, its kind implements `radiance_KIND` in WGSL; if rays continue, it implements `scatter_KIND`. All
//! kinds share the record `Material` and read different members of it.
//!
//! *Practice.* [`KINDS`] lists each kind once. To add a kind, add a WGSL file, a file here and a line of that table.

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

use super::dyn_eq::same;
use super::{DynEq, Row};
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

/// Reads the color of a material and its behavior; returns `None` after an error.
type Read = fn(&TableReader, &mut Files) -> Option<(Pattern, Arc<dyn Surface>)>;
type Kind = document::Kind<Read>;

/// The table of all materials; a new kind needs one line here.
pub static KINDS: Kinds<Read> = Kinds {
    table: "materials.NAME",
    chooser: "kind",
    meaning: "how the surface reflects, transmits or emits light",
    example: None,
    all: &[&phong::KIND, &emissive::KIND, &blackbody::KIND, &accretion::KIND, &mirror::KIND, &glossy::KIND, &fan::KIND],
};

/// A table `[materials.NAME]`.
#[derive(Debug, Clone)]
pub struct Material {
    /// The name in the scene file.
    pub name: String,
    /// The color over the surface, which the kind interprets.
    pub color: Pattern,
    /// The behavior of the surface.
    pub surface: Arc<dyn Surface>,
}

impl PartialEq for Material {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.color == other.color && *self.surface == *other.surface
    }
}

/// The properties of a surface that do not depend on its color.
#[derive(Debug, Clone)]
#[allow(clippy::struct_excessive_bools)] // facts, each by itself
pub struct SurfaceProperties<'a> {
    /// The path of the WGSL module; its last name is the suffix of the functions and, in capitals, of the code.
    pub part: &'static str,
    /// Is `true` if rays continue from the surface.
    pub continues: bool,
    /// Is `true` if a ray that continues from the surface leaves the path that the law alone defines.
    pub deflects: bool,
    /// The fraction of a ray's light that the surface contributes if rays end on it; the rest comes from straight behind.
    pub opacity: f64,
    /// The user-defined directions of a ray splitter, if the surface is one.
    pub fan: Option<&'a [FanRay]>,
    /// Is `true` if next-event estimation samples the surface when it emits.
    pub is_aimed_at: bool,
    /// Is `true` if the direction of a continuing ray is sampled from a lobe.
    pub has_lobe: bool,
    /// Is `true` if the surface reflects light in a lobe around the mirror direction.
    pub is_glossy: bool,
    /// Is `true` if the color follows from a temperature.
    pub has_temperature: bool,
    /// Is `true` if the surface orbits like the law's matter instead of being static.
    pub orbits: bool,
    /// Is `true` if the scene's lights illuminate the surface.
    pub is_lit: bool,
}

impl SurfaceProperties<'_> {
    /// Returns the properties of a surface on which rays end, with this WGSL module.
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

    /// Returns the properties of a surface from which rays continue, with this WGSL module.
    #[must_use]
    pub fn scattering(part: &'static str) -> Self {
        Self { continues: true, deflects: true, ..Self::ending(part) }
    }
}

/// The behavior of a surface.
pub trait Surface: fmt::Debug + Send + Sync + DynEq {
    /// Returns the properties that do not depend on the color.
    fn facts(&self) -> SurfaceProperties<'_>;

    /// Returns the members of `Material` that only this kind has.
    fn values(&self) -> Row {
        Row::new()
    }

    /// Returns the temperature of the hottest part in kelvins, if the surface radiates as a black body.
    fn temperature(&self) -> Option<f64> {
        None
    }

    /// Returns the mean emitted radiance; `color` is the mean of the pattern.
    fn emission(&self, _color: DVec3) -> DVec3 {
        DVec3::ZERO
    }

    /// Returns an upper bound of the reflected fraction of light at a point of this color.
    fn albedo(&self, _color: DVec3) -> DVec3 {
        DVec3::ZERO
    }
}

same!(Surface);

/// Reads all materials, and returns all names and the materials without errors, both in the order of the file. With `paths`, no material
/// may reflect more light than it receives.
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

/// Reports a surface that reflects more light than it receives, because the throughput of a path would grow without limit.
fn check_albedo(table: &TableReader, material: &Material, pictures: &[Picture]) {
    let albedo = material.surface.albedo(material.color.largest(pictures)).max_element();
    if albedo > 1.0 + 1e-9 {
        let problem = format!("this surface reflects up to {albedo:.4} times the light that it receives");
        table.fault(&[], problem, "for path tracing, reduce its colors to a sum of at most 1 per channel");
    }
}
