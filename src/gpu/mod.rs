//! Manages the device and a scene's resources on it: pipelines, buffers and textures.
//!
//! *Practice.* [`Gpu`] lives as long as the process, [`Pipelines`] as long as one linked program, [`SceneBuffers`] as long as one scene,
//! and [`Tile`] as long as one tile of an image. Bindings are found by their [role](crate::program::Role), and all layouts come from naga's
//! reflection, so nothing is declared twice.

mod compiled;
mod contents;
mod device;
mod driver_messages;
mod emission;
mod error;
mod geometry;
mod glow;
mod hierarchy;
mod instances;
mod light_grid_data;
mod limits;
mod lists;
mod media;
mod mesh;
mod pipeline;
mod ray_tree;
mod records;
mod slots;
mod source;
mod star_buckets;
mod stars;
mod structure;
mod textures;
mod tile;
mod uniforms;

pub use compiled::{Division, Pipeline};
pub use contents::{SceneBuffers, Stored};
pub use device::{AdapterReport, Gpu, adapters};
pub(crate) use emission::hashed;
pub use emission::{Aim, Emission};
pub use error::GpuError;
pub use geometry::{Geometry, PreviousGeometry};
pub use hierarchy::{Item, Node};
pub use instances::{InstancedMesh, Instances};
pub use light_grid_data::{LightGridData, LightVolume, light_bytes};
pub use limits::{check_meshes, mesh_capacity};
pub use pipeline::Pipelines;
pub use records::pack;
pub use slots::{FRAMES, List, PixelListKind, SECTION, Sections, Selection, Slots, WORK_HEAD};
pub use star_buckets::star_bytes;
pub use structure::{AccelStructure, Grid};
pub use textures::halved_pictures;
pub use tile::{Memory, Tile, memory};
pub use uniforms::schedule_values;
