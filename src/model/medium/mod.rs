//! Media: how the index of refraction n varies with place. The contract, and the table of kinds.
//!
//! *Theory.* Light in a medium moves by dx = v, dv = ∇(n²/2) with |v| = n. The WGSL contract is `medium_index(x)`,
//! `medium_pull(x)` = ∇(n²/2) and `medium_length(x)`, the length over which n changes; media whose paths have a closed form name it.
//!
//! *Practice.* [`KINDS`] names each kind once. Adding one is a WGSL file, a file here and a line of that table.

mod constant;
mod eaton;
mod explosion;
mod exponential;
mod expression;
mod fisheye;
mod gaussian;
mod gloss;
mod grid;
mod inverse_r;
mod linear;
mod luneburg;
mod noise;
mod profile;
mod rod;
mod sech;
mod sellmeier;
mod textured;

use std::fmt;
use std::sync::Arc;

use glam::DVec3;

use super::same::same;
use super::{Capture, ClosedForm, Filter, Row, Same, Wgsl, filter};
use crate::assets::{Files, Formula};
use crate::document::reader::TableReader;
use crate::document::values::{direction, positive, suggest, vector};
use crate::document::{self, Key, Kinds, Node, Value, keys};

pub use constant::{COMMON, Constant};
pub use eaton::Eaton;
pub use explosion::Explosion;
pub use exponential::Exponential;
pub use expression::Expression;
pub use fisheye::Fisheye;
pub use gaussian::Gaussian;
pub use gloss::Gloss;
pub use grid::Grid;
pub use inverse_r::{Ingoing, InverseR};
pub use linear::Linear;
pub use luneburg::Luneburg;
pub use noise::Noise;
pub use profile::Layers;
pub use rod::Rod;
pub use sech::Sech;
pub use sellmeier::{D_LINE, Sellmeier, VISIBLE};
pub use textured::Textured;

/// Reads a medium; none if it cannot be used.
type Read = fn(&TableReader, Surroundings, &mut Files) -> Option<Arc<dyn Medium>>;
type Kind = document::Kind<Read>;

/// Every kind of medium. Adding one is a line here.
pub static KINDS: Kinds<Read> = Kinds {
    table: "medium",
    chooser: "kind",
    meaning: "profile of the index n; a number means { kind = \"constant\", n }, and so do the names of common media: \
              vacuum, air, ice, water, ethyl-alcohol, fused-quartz, acrylic, crown-glass, polyester-resin, \
              flint-glass and diamond",
    example: Some("luneburg"),
    all: &[
        &constant::KIND,
        &sellmeier::KIND,
        &luneburg::KIND,
        &gaussian::KIND,
        &inverse_r::KIND,
        &fisheye::KIND,
        &eaton::KIND,
        &rod::KIND,
        &linear::KIND,
        &exponential::KIND,
        &sech::KIND,
        &profile::KIND,
        &noise::KIND,
        &textured::KIND,
        &explosion::KIND,
        &expression::KIND,
        &grid::KIND,
    ],
};

/// What is where nothing else is.
pub const VACUUM: Constant = Constant { n: 1.0 };

/// What is known of a medium whatever the place.
#[derive(Debug, Clone, Default)]
pub struct Facts<'a> {
    /// The WGSL that keeps the contract.
    pub parts: Vec<Wgsl>,
    /// Its paths in closed form, if they have one.
    pub closed_form: Option<&'static ClosedForm>,
    /// Is the index another for each wavelength?
    pub is_dispersive: bool,
    /// Does the index vary over surfaces alone, so that it can be no law's?
    pub is_of_surfaces: bool,
    /// Where rays end in it.
    pub capture: Option<Capture>,
    /// The center about which a path in closed form leaves a ball as it came in.
    pub center: Option<DVec3>,
    /// The sphere at which its formula ends, if there is one: center and radius.
    pub edge: Option<(DVec3, f64)>,
    /// How many terms one evaluation of the index with its gradient adds up, each about as long as a simple medium.
    pub terms: u32,
    /// A formula that the index is written by, to be turned into WGSL with its gradient.
    pub formula: Option<&'a Formula>,
    /// Numbers of the list `index_samples`.
    pub samples: &'a [f32],
}

impl Facts<'_> {
    /// Returns the facts of a medium without a closed form, by these parts of `shaders/`.
    #[must_use]
    pub fn of(parts: &[&'static str]) -> Self {
        Self { parts: Wgsl::parts(parts), terms: 1, ..Self::default() }
    }

    /// Returns its paths in closed form, if they have one; `ends` where they end at a given τ, which is not what all are measured by.
    #[must_use]
    pub fn closed_form(&self, ends: bool) -> Option<&'static ClosedForm> {
        self.closed_form.filter(|form| !ends || form.ends())
    }

    /// Returns `true` if light is bent in it.
    #[must_use]
    pub fn bends(&self) -> bool {
        self.closed_form.is_none_or(|form| !form.is_line)
    }
}

/// An index of refraction over space, in scene coordinates. Spherical media are functions of r, the distance from their center.
pub trait Medium: fmt::Debug + Send + Sync + Same {
    /// What is known of it whatever the place.
    fn facts(&self) -> Facts<'_>;

    /// The members of its `Medium` in WGSL. What it has in lists for all media begins at `first` there.
    fn values(&self, first: u32) -> Row;

    /// n at a place; 0 where a formula's n² is not positive, and no light comes; none where only the shaders know.
    fn index(&self, x: DVec3) -> Option<f64>;

    /// Returns why the index is not known for light of this wavelength, in nanometers; `None` where it is.
    fn refuses_wavelength(&self, wavelength: f64) -> Option<String> {
        let _ = wavelength;
        None
    }

    /// Rows of the list `profile`.
    fn points(&self) -> Vec<Row> {
        Vec::new()
    }
}

same!(Medium);

/// What an object is filled with: light goes through it.
#[derive(Debug, Clone)]
pub struct Interior {
    /// Its index.
    pub medium: Arc<dyn Medium>,
    /// What it takes from light, or adds to it.
    pub filter: Option<Box<Filter>>,
    /// How rough its surface is.
    pub gloss: Gloss,
    /// Where interiors overlap, the one of the higher priority is there.
    pub priority: u32,
}

impl Interior {
    /// A medium by itself.
    #[must_use]
    pub fn new(medium: Arc<dyn Medium>) -> Self {
        Self { medium, filter: None, gloss: Gloss::default(), priority: 0 }
    }
}

impl PartialEq for Interior {
    fn eq(&self, other: &Self) -> bool {
        *self.medium == *other.medium
            && self.filter == other.filter
            && self.gloss == other.gloss
            && self.priority == other.priority
    }
}

/// What a medium's own keys default to: the place and size of the object that it fills.
#[derive(Debug, Clone, Copy, Default)]
pub struct Surroundings {
    /// The object's middle; the origin for a medium that fills all space.
    pub center: DVec3,
    /// Of a sphere or cylinder.
    pub radius: Option<f64>,
    /// Of a cylinder.
    pub axis: Option<DVec3>,
}

/// `center`.
const CENTER: Key = keys! {
    center: "[x, y, z]" = "the object's, or [0, 0, 0]",
        "point of r = 0, a point on the axis of the rod, or the origin of the noise lattice; scene units";
}[0];
/// `radius`.
const RADIUS: Key = keys! { radius: "number above 0" = "the object's, or required", "R, scene units"; }[0];
/// `origin`.
const ORIGIN: Key = keys! {
    origin: "[x, y, z]" = "the object's center, or [0, 0, 0]", "a point of height 0";
}[0];
/// `up`.
const UP: Key = keys! { up: "[x, y, z]" = "[0, 1, 0]", "direction of increasing height"; }[0];

fn center(table: &TableReader, around: Surroundings) -> DVec3 {
    table.or("center", around.center, vector)
}

/// A length that is the object's radius, if that has one.
fn length(table: &TableReader, key: &'static str, example: &str, around: Surroundings) -> Option<f64> {
    match around.radius {
        Some(radius) => Some(table.or(key, radius, positive)),
        None => table.required(key, example, positive),
    }
}

fn origin(table: &TableReader, around: Surroundings) -> DVec3 {
    table.or("origin", around.center, vector)
}

fn up(table: &TableReader) -> DVec3 {
    table.or("up", DVec3::Y, direction)
}

/// √ of what is positive, else 0.
fn root(square: f64) -> f64 {
    square.max(0.0).sqrt()
}

/// The medium that a node gives: a number, a name, or a table with a `kind`.
pub(crate) fn read(
    parent: &TableReader,
    node: &Node,
    around: Surroundings,
    files: &mut Files,
) -> Option<Arc<dyn Medium>> {
    match &node.value {
        Value::Table(_) => {
            let table = parent.reader.open("medium", node)?;
            let medium = KINDS.chosen(&table).and_then(|read| read(&table, around, files));
            table.finish();
            medium
        }
        _ => named(parent, node),
    }
}

/// What an object is filled with: a medium, and in its table what belongs to interiors alone.
pub(crate) fn read_interior(
    parent: &TableReader,
    node: &Node,
    around: Surroundings,
    files: &mut Files,
) -> Option<Interior> {
    if !matches!(node.value, Value::Table(_)) {
        return named(parent, node).map(Interior::new);
    }
    let table = parent.reader.open("medium", node)?;
    let medium = KINDS.chosen(&table).and_then(|read| read(&table, around, files));
    let filter = table.node("absorption").map(|node| filter::read(&table, node, around.center, files));
    let gloss = gloss::read(&table);
    table.finish();
    let filter = match filter {
        Some(filter) => Some(Box::new(filter?)),
        None => None,
    };
    Some(Interior { filter, gloss, ..Interior::new(medium?) })
}

/// A medium without a table: a number or a name.
fn named(parent: &TableReader, node: &Node) -> Option<Arc<dyn Medium>> {
    let reader = parent.reader;
    match &node.value {
        Value::Text(name) => {
            let names: Vec<&str> = COMMON.iter().map(|(name, _)| *name).collect();
            let known = COMMON.iter().find(|(known, _)| known == name);
            if known.is_none() {
                reader.fault(node.fault(format!("unknown medium `{name}`"), suggest(name, &names, "media")));
            }
            known.map(|(_, n)| Arc::new(Constant { n: *n }) as Arc<dyn Medium>)
        }
        _ => reader.accept(positive(node)).map(|n| Arc::new(Constant { n }) as Arc<dyn Medium>),
    }
}
