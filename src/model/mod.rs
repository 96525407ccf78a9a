//! The rooms: everything that the program knows of a kind of law, medium, material, shape, camera, falloff, method or control.
//!
//! *Theory.* A kind is one Rust file here beside one WGSL file in `shaders/`. The Rust file says how its keys are read and what they
//! mean, which WGSL parts keep its contract and what values those are fed, and every property that anything
//! else asks for: invariants, captures, outlines, the order of a law, the closed form of a medium. The traits [`Law`], [`Medium`],
//! [`Surface`], [`Shape`] and [`Projection`] and the rows [`method::Kind`], [`control::Kind`] and [`falloff::Kind`] are those
//! questions; the rest of the program asks them and knows no kind by name.
//!
//! *Practice.* Each folder's `mod.rs` has its contract and its table, with one line for each kind. Nothing here knows of a GPU: parts
//! are names, and values are numbers by the names of WGSL's members. A user of the library implements [`Law`] or [`Medium`] for a
//! kind of their own, with WGSL as text, and puts it into a [`Scene`](crate::scene::Scene).

pub mod black_body;
pub mod camera;
pub mod control;
pub mod cut;
pub mod falloff;
pub mod filter;
mod halved;
pub mod law;
pub mod material;
pub mod matter;
pub mod medium;
pub mod method;
mod motion;
mod part;
mod same;
pub mod shape;
pub mod source;
mod value;

pub use camera::{Camera, Projection, Stereo, StereoLayout};
pub use control::Control;
pub use filter::Filter;
pub use law::{CameraFrame, Invariant, Landmark, Law, Orbit, Order};
pub use material::{Material, Pattern, Surface};
pub use medium::{Gloss, Interior, Medium};
pub use method::Method;
pub use motion::{CIRCLE, ClosedForm, HARMONIC, PARABOLA, SPIRAL, STRAIGHT, Start};
pub use part::{OwnWgsl, Promise, Wgsl};
pub use same::Same;
pub use shape::{Object, Shape, Substance, Travel};
pub use source::{Anchor, Capture, Source};
pub use value::{Binding, Row, Value};

pub(crate) use value::{fields, row};
