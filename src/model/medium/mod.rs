//! Media, which define the index of refraction n over space: the contract and the table of kinds.
//!
//! *Theory.* Light in a medium moves by dx = v, dv = ∇(n²/2) with |v| = n. The WGSL contract is `medium_index(x)`, `medium_pull(x)` =
//! ∇(n²/2) and `medium_length(x)`, the length over which n changes. Media with closed-form paths name the closed form.
//!
//! *Practice.* [`KINDS`] lists each kind once. To add a kind, add a WGSL file, a file here and a line of that table.

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

use super::dyn_eq::same;
use super::{Absorption, Capture, ClosedForm, DynEq, Row, Wgsl, absorption};
use crate::assets::{Files, Formula};
use crate::document::reader::TableReader;
use crate::document::values::{direction, point, positive, positive_length, suggest};
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

/// Reads a medium; returns `None` after an error.
type Read = fn(&TableReader, Surroundings, &mut Files) -> Option<Arc<dyn Medium>>;
type Kind = document::Kind<Read>;

/// The table of all media; a new kind needs one line here.
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

/// The medium outside of all others.
pub const VACUUM: Constant = Constant { n: 1.0 };

/// The properties of a medium that do not depend on position.
#[derive(Debug, Clone, Default)]
pub struct MediumProperties<'a> {
    /// The WGSL modules that implement the contract.
    pub parts: Vec<Wgsl>,
    /// The closed form of the paths, if there is one.
    pub closed_form: Option<&'static ClosedForm>,
    /// Is `true` if the index depends on wavelength.
    pub is_dispersive: bool,
    /// Is `true` if the index varies over surfaces alone, so that no law can use the medium.
    pub is_of_surfaces: bool,
    /// The region in which rays end, if there is one.
    pub capture: Option<Capture>,
    /// The center of a ball that a closed-form path leaves symmetrically to its entry.
    pub center: Option<DVec3>,
    /// The center and radius of the sphere where the formula ends, if there is one.
    pub edge: Option<(DVec3, f64)>,
    /// The number of terms of an evaluation of the index and its gradient, each about as expensive as a simple medium.
    pub terms: u32,
    /// The formula of the index, from which WGSL with a gradient is generated.
    pub formula: Option<&'a Formula>,
    /// The elements of the list `index_samples`.
    pub samples: &'a [f32],
}

impl MediumProperties<'_> {
    /// Returns the properties of a medium without a closed form, with these modules of `shaders/`.
    #[must_use]
    pub fn of(parts: &[&'static str]) -> Self {
        Self { parts: Wgsl::parts(parts), terms: 1, ..Self::default() }
    }

    /// Returns the closed form of the paths, if there is one; `ends` if paths end at a given τ, which not every motion measures.
    #[must_use]
    pub fn closed_form(&self, ends: bool) -> Option<&'static ClosedForm> {
        self.closed_form.filter(|form| !ends || form.ends())
    }

    /// Returns `true` if the medium bends light.
    #[must_use]
    pub fn bends(&self) -> bool {
        self.closed_form.is_none_or(|form| !form.is_line)
    }
}

/// An index of refraction over space, in scene coordinates. Spherical media depend on r, the distance from their center.
pub trait Medium: fmt::Debug + Send + Sync + DynEq {
    /// Returns the properties that do not depend on position.
    fn facts(&self) -> MediumProperties<'_>;

    /// Returns the members of its `Medium` in WGSL. `first` is the index of its first element in lists shared by all media.
    fn values(&self, first: u32) -> Row;

    /// Returns n at a position: 0 if a formula's n² is not positive, so that no light reaches it, and `None` if only the shaders can
    /// compute n.
    fn index(&self, x: DVec3) -> Option<f64>;

    /// Returns why the index is unknown for this wavelength in nanometers, or `None` if it is known.
    fn refuses_wavelength(&self, wavelength: f64) -> Option<String> {
        let _ = wavelength;
        None
    }

    /// Returns the rows of the list `profile`.
    fn points(&self) -> Vec<Row> {
        Vec::new()
    }
}

same!(Medium);

/// The interior of a transparent object.
#[derive(Debug, Clone)]
pub struct Interior {
    /// The medium.
    pub medium: Arc<dyn Medium>,
    /// The absorption and emission.
    pub absorption: Option<Box<Absorption>>,
    /// The roughness of the surface.
    pub gloss: Gloss,
    /// The priority; where interiors overlap, the one with the higher priority wins.
    pub priority: u32,
}

impl Interior {
    /// Creates an interior from a medium alone.
    #[must_use]
    pub fn new(medium: Arc<dyn Medium>) -> Self {
        Self { medium, absorption: None, gloss: Gloss::default(), priority: 0 }
    }
}

impl PartialEq for Interior {
    fn eq(&self, other: &Self) -> bool {
        *self.medium == *other.medium
            && self.absorption == other.absorption
            && self.gloss == other.gloss
            && self.priority == other.priority
    }
}

/// The defaults of a medium's keys, from the placement of the object that it fills.
#[derive(Debug, Clone, Copy, Default)]
pub struct Surroundings {
    /// The center of the object; the origin for a medium that fills all of space.
    pub center: DVec3,
    /// The radius of a sphere or cylinder.
    pub radius: Option<f64>,
    /// The axis of a cylinder.
    pub axis: Option<DVec3>,
}

/// The key `center`.
const CENTER: Key = keys! {
    center: "[x, y, z]" = "the object's, or [0, 0, 0]",
        "point of r = 0, a point on the axis of the rod, or the origin of the noise lattice; scene units";
}[0];
/// The key `radius`.
const RADIUS: Key = keys! { radius: "number above 0" = "the object's, or required", "R, scene units"; }[0];
/// The key `origin`.
const ORIGIN: Key = keys! {
    origin: "[x, y, z]" = "the object's center, or [0, 0, 0]", "a point at height 0";
}[0];
/// The key `up`.
const UP: Key = keys! { up: "[x, y, z]" = "[0, 1, 0]", "direction of increasing height"; }[0];

fn center(table: &TableReader, around: Surroundings) -> DVec3 {
    table.or("center", around.center, point)
}

/// Reads a length that defaults to the object's radius, if it has one.
fn length(table: &TableReader, key: &'static str, example: &str, around: Surroundings) -> Option<f64> {
    match around.radius {
        Some(radius) => Some(table.or(key, radius, positive_length)),
        None => table.required(key, example, positive_length),
    }
}

fn origin(table: &TableReader, around: Surroundings) -> DVec3 {
    table.or("origin", around.center, point)
}

fn up(table: &TableReader) -> DVec3 {
    table.or("up", DVec3::Y, direction)
}

/// Returns the square root of a positive number, and otherwise 0.
fn root(square: f64) -> f64 {
    square.max(0.0).sqrt()
}

/// Reads a medium from a node: a number, a name, or a table with a `kind`.
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

/// Reads an interior: a medium, and in its table the keys of interiors alone.
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
    let absorption = table.node("absorption").map(|node| absorption::read(&table, node, around.center, files));
    let gloss = gloss::read(&table);
    table.finish();
    let absorption = match absorption {
        Some(absorption) => Some(Box::new(absorption?)),
        None => None,
    };
    Some(Interior { absorption, gloss, ..Interior::new(medium?) })
}

/// Reads a medium without a table: a number or a name.
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
