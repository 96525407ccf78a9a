//! glTF 2.0: scenes of nodes with meshes, as JSON next to or before the binary data that it describes.
//!
//! *Theory.* Nodes form trees; each has a map from its space to its parent's. Meshes consist of primitives, each with its material, and
//! their numbers are described by accessors: the position in a buffer, the number and the type of the elements.
//!
//! *Practice.* `gltf-json` parses the JSON. Its validation is not used, because it may panic if an index is invalid. Every
//! index, length and offset is therefore checked here before use, and errors name objects as the file does, such as `accessors[3]`.

mod accessor;
mod container;
mod images;
mod nodes;

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use gltf_json::{Index, Root, root::Get};

use super::format_error::FormatError;

pub(super) use accessor::Elements;
pub use gltf_json as json;
pub use images::{Stored, image_of};
use nodes::{Map, WithMesh};
pub use nodes::{NodeName, Placed, names};

/// A glTF file, and the binary data that it describes.
#[derive(Debug)]
pub struct Gltf {
    /// The parsed JSON.
    pub root: Root,
    /// The map from each node to its parent, in 64 bits.
    maps: Vec<Map>,
    path: PathBuf,
    /// The bytes of the file, and the range of its own buffer in them.
    bytes: Vec<u8>,
    own: Option<std::ops::Range<usize>>,
    /// The other buffers, loaded when they are first needed.
    buffers: Vec<OnceLock<Result<Vec<u8>, FormatError>>>,
    /// The nodes with a mesh, found when they are first needed.
    with_mesh: OnceLock<Result<WithMesh, FormatError>>,
}

impl Gltf {
    /// Returns the file's path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the object with this index; `list` is the name of its list in the file, and `of` names the object that contains the index.
    fn get<T>(&self, index: Index<T>, list: &str, of: &str) -> Result<&T, FormatError>
    where
        Root: Get<T> + AsRef<[T]>,
    {
        self.root.get(index).ok_or_else(|| {
            let all: &[T] = self.root.as_ref();
            FormatError(format!(
                "{of} refers to {list}[{}], and there are {}, counted from 0",
                index.value(),
                all.len()
            ))
        })
    }
}
