//! Assets of scenes: meshes, images, profiles and grids from files, formulas, and transforms.
//!
//! *Practice.* [`Files`] loads each file once, however often scenes name it.

mod catalog;
mod expression;
mod files;
mod format_error;
mod gltf;
mod grid;
mod mesh;
mod picture;
mod profile;
mod star_table;
mod transform;
mod winding;

pub use catalog::Catalog;
pub use expression::{
    Coefficients, Curve, Emissivity, FanRay, Field, Formula, FormulaError, Function, Graph, Id, Interval, LineElement,
    MOST_GRIDS, Node, Spacetime, Spot, Variable, VolumeField, VolumeFormulas, VolumeTexts,
};
pub use files::Files;
pub use gltf::{Gltf, NodeName, Placed, Stored as StoredPicture, image_of, json, names};
pub use grid::{GridUse, RawGridLayout, SampledGrid, Stored};
pub use mesh::{Capacity, Held, Mesh, MeshPart, MeshRequest, MeshSource, Vertex};
pub use picture::Picture;
pub(crate) use picture::unlikely_exr;
pub use profile::{Profile, ProfileError, ProfilePoint};
pub use star_table::Star;
pub use transform::Transform;
