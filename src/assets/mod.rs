//! Assets of scenes: meshes, images, profiles and grids from files, formulas, and transforms.
//!
//! *Practice.* [`Files`] loads each file once, however often scenes name it.

mod expression;
mod files;
mod flaw;
mod gltf;
mod grid;
mod mesh;
mod picture;
mod profile;
mod transform;
mod winding;

pub use expression::{
    Curve, FanRay, Field, Formula, FormulaError, Function, Graph, Id, Interval, LineElement, Node, Spacetime, Spot,
    Variable,
};
pub use files::Files;
pub use gltf::{Gltf, NodeName, Placed, Stored as StoredPicture, image_of, json, names};
pub use grid::{Bare, IndexGrid, Stored, Use};
pub use mesh::{Capacity, Held, Mesh, Part, Source, Vertex, Wanted};
pub use picture::Picture;
pub(crate) use picture::unlikely_exr;
pub use profile::{Flaw, Profile, ProfilePoint};
pub use transform::Transform;
