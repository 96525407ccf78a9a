//! glTF 2.0: scenes of nodes with meshes, as JSON beside or before the bytes that it speaks of.
//!
//! *Theory.* Nodes are trees; each has a map from its space to its parent's. Meshes are of primitives, each with a material of its own, and
//! their numbers are described by accessors: where in a buffer they are, how many, and of what kind.
//!
//! *Practice.* `gltf-json` says what the JSON is. Its own validation is not asked: it may panic where an index is wrong. So every
//! index, length and offset is checked here before it is used, and what is wrong is named as the file names it, such as `accessors[3]`.

mod accessor;
mod container;
mod images;
mod nodes;

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use gltf_json::{Index, Root, root::Get};

use super::flaw::Flaw;

pub(super) use accessor::Elements;
pub use gltf_json as json;
pub use images::{Stored, image_of};
use nodes::{Map, WithMesh};
pub use nodes::{NodeName, Placed, names};

/// A file, and the bytes that it speaks of.
#[derive(Debug)]
pub struct Gltf {
    /// What it says.
    pub root: Root,
    /// Each node's map to its parent, in 64 bits.
    maps: Vec<Map>,
    path: PathBuf,
    /// The bytes of the file, and where in them its own buffer is.
    bytes: Vec<u8>,
    own: Option<std::ops::Range<usize>>,
    /// The other buffers, as far as they were asked for.
    buffers: Vec<OnceLock<Result<Vec<u8>, Flaw>>>,
    /// The nodes with a mesh, once they were asked for.
    with_mesh: OnceLock<Result<WithMesh, Flaw>>,
}

impl Gltf {
    /// The file's path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// What an index of the file is of; `list` is the name of that list there, and `of` what has the index.
    fn get<T>(&self, index: Index<T>, list: &str, of: &str) -> Result<&T, Flaw>
    where
        Root: Get<T> + AsRef<[T]>,
    {
        self.root.get(index).ok_or_else(|| {
            let all: &[T] = self.root.as_ref();
            Flaw(format!("{of}: there is no {list}[{}]; there are {}, counted from 0", index.value(), all.len()))
        })
    }
}
