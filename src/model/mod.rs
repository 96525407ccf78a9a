//! The registry of kinds: all laws, media, materials, shapes, cameras, fall-offs, methods and step-size controls.
//!
//! *Theory.* A kind is one Rust file here with one WGSL file in `shaders/`. The Rust file defines how its keys are read, which WGSL modules
//! implement its contract, their values, and every property that other code needs: invariants, capture regions, outlines, the order of a
//! law, the closed form of a medium. The traits [`Law`], [`Medium`], [`Surface`], [`Shape`] and [`Projection`] and the rows
//! [`method::MethodKind`], [`control::ControlKind`] and [`falloff::FalloffKind`] define these properties; the rest of the program uses them and depends on no
//! kind by name.
//!
//! *Practice.* The `mod.rs` of each folder contains its contract and its table, with one line per kind. Nothing here depends on a GPU:
//! modules are names, and values are numbers with the names of WGSL members. Users of the library implement [`Law`] or [`Medium`] for a
//! custom kind, with WGSL as text, and put it into a [`Scene`](crate::scene::Scene).

pub mod absorption;
pub mod black_body;
pub mod camera;
pub mod control;
pub mod cross_section;
mod dyn_eq;
pub mod falloff;
mod grid;
mod halved;
pub mod law;
pub mod material;
pub mod matter;
pub mod medium;
pub mod method;
mod motion;
mod part;
pub mod point_source;
pub mod shape;
mod value;
pub mod volume;

pub use absorption::Absorption;
pub use camera::{Camera, Projection, Stereo, StereoLayout};
pub use control::Control;
pub use dyn_eq::DynEq;
pub use law::{CharacteristicSurface, Invariant, Law, Observer, Orbit, Order};
pub use material::{Material, Pattern, Surface};
pub use medium::{Gloss, Interior, Medium};
pub use method::Method;
pub use motion::{CIRCLE, ClosedForm, HARMONIC, PARABOLA, SPIRAL, STRAIGHT, Start};
pub use part::{Promise, UserWgsl, Wgsl};
pub use point_source::{Anchor, Capture, Source};
pub use shape::{Object, RigidMotion, Shape, Substance};
pub use value::{Binding, Row, Value};
pub use volume::{Radiation, Volume};

pub(crate) use value::{fields, row};
