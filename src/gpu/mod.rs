//! The device, and a scene as what lies on it: pipelines, buffers, textures.
//!
//! *Practice.* [`Gpu`] lives as long as the process; a [`Pipelines`] as long as one linked program; [`SceneBuffers`] as long as
//! one scene; [`Tile`] as long as one tile of a picture. Every binding is found by its name in the WGSL, and every layout is
//! that which naga reflected: nothing is repeated here.

mod contents;
mod device;
mod error;
mod geometry;
mod hierarchy;
mod lists;
mod media;
mod pipeline;
mod records;
mod structure;
mod tile;
mod uniforms;

pub use contents::{SceneBuffers, copy_of};
pub use device::{AdapterReport, Gpu, adapters};
pub use error::GpuError;
pub use geometry::Geometry;
pub use hierarchy::{Item, Node};
pub use pipeline::{Pipeline, Pipelines};
pub use records::pack;
pub use structure::{Built, Grid};
pub use tile::{Memory, OPEN, Parts, Slots, TURN_STRIDE, Tile, WANTED, memory};
pub use uniforms::schedule_values;
