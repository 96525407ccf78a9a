//! Meshes: files as triangles with positions, normals and texture coordinates.
//!
//! *Theory.* A file contains corners of faces, and perhaps normals. Faces may be any simple polygons; [`Raw`] triangulates them.
//! Missing normals are smooth across edges whose faces meet at less than the crease angle, and equal to the face's normal elsewhere.
//!
//! *Practice.* [`FORMATS`] lists each format once, by its file extensions. To add a format, add a file here and
//! a line to that table. A reader trusts no count before it has seen as many bytes, and stops if there are more
//! triangles than the [`Capacity`] allows. Triangles without area are dropped, and equal corners share a vertex.

mod bytes;
mod capacity;
mod cells;
mod colors;
mod edges;
mod gltf;
mod inside;
mod joined;
mod normals;
mod obj;
mod ply;
mod raw;
mod stl;
mod text;

use std::path::{Path, PathBuf};

use glam::{DAffine3, DVec3, Vec2, Vec3};

use super::gltf::NodeName;
use crate::document::{SceneError, read_bytes};
use crate::progress::Stage;
pub use capacity::{Capacity, Held};
use cells::Cells;
use inside::Inside;
use raw::Raw;

/// Triangles in object space, which is the file's space, moved by [`Mesh::origin`] if the file's coordinates are large.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// The vertices, each used by at least one triangle.
    pub vertices: Vec<Vertex>,
    /// Indices into the vertices, counter-clockwise seen from outside if the file winds them so; [`Mesh::solids`] always are.
    pub triangles: Vec<[u32; 3]>,
    /// The linear color of each vertex, with components from 0 to 1; empty if the file has none.
    pub colors: Vec<Vec3>,
    /// The origin of object space in the file's space: positions in the file are `origin + position`. A
    /// component is zero if the mesh is nearer to the file's origin along that axis than the mesh is large.
    pub origin: DVec3,
    /// The elements of the file that are not drawn, such as `lines (3)`.
    pub left_out: Vec<String>,
    /// The reason why the file's colors cannot be used, if any.
    color_flaw: Option<String>,
    /// The vertices passed to [`Mesh::new`], grouped by position.
    cells: Cells,
    radius: f64,
    inside: Inside,
}

/// A vertex of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// The position in object space.
    pub position: Vec3,
    /// The normal, a unit vector.
    pub normal: Vec3,
    /// The texture coordinates; (0, 0) if the file has none.
    pub uv: Vec2,
}

/// The requested part of a file, and how to read it.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshRequest {
    /// The crease angle in degrees: faces that meet at a larger angle have a visible edge, if the file has no normals.
    pub crease: f64,
    /// The part of the file.
    pub part: MeshPart,
}

/// A part of a file with several nodes and primitives.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash)]
pub struct MeshPart {
    /// The node with the mesh; `None` for all nodes.
    pub node: Option<NodeName>,
    /// The index of the mesh's primitive, from 0; `None` for all primitives.
    pub primitive: Option<u32>,
}

/// The source of triangles; nodes of a file that show equal triangles have equal sources.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum MeshSource {
    /// A part of a file, transformed to the file's scene.
    Placed(MeshPart),
    /// A mesh of a file in object space.
    Own {
        /// The index in the file's list of meshes.
        mesh: usize,
        /// The index of its primitive, from 0; `None` for all primitives.
        primitive: Option<u32>,
    },
}

impl MeshRequest {
    /// The default crease angle in degrees: smaller than the angles at intended edges, and larger than the angles between
    /// faces that approximate a smooth surface.
    pub const CREASE: f64 = 30.0;
}

impl Default for MeshRequest {
    fn default() -> Self {
        Self { crease: Self::CREASE, part: MeshPart::default() }
    }
}

/// A file format.
struct Format {
    /// The file extensions.
    extensions: &'static [&'static str],
    read: Read,
}

/// The function that reads a file.
enum Read {
    /// The whole file is one mesh.
    Whole(fn(&[u8], &Path, Reading) -> Result<Raw, SceneError>),
    /// The file has parts, which are read one by one.
    Parts(fn(Vec<u8>, &Path) -> OpenedParts),
}

/// The context of reading a file.
#[derive(Clone, Copy)]
pub(super) struct Reading<'a> {
    /// The stage to which bytes read are reported.
    pub stage: &'a Stage,
    /// The limit on the number of triangles.
    pub capacity: &'a Capacity,
}

type OpenedParts = Result<Box<dyn Parts>, SceneError>;

/// All formats.
const FORMATS: [&Format; 4] = [&obj::FORMAT, &ply::FORMAT, &stl::FORMAT, &gltf::FORMAT];

/// A file with several parts.
pub(super) trait Parts: std::fmt::Debug + Send + Sync {
    /// Returns the source of a part, and the map from the source to the file's scene.
    fn find(&self, part: &MeshPart) -> Result<(MeshSource, DAffine3), SceneError>;

    /// Reads the triangles of a source, if the capacity allows them.
    fn read(&self, source: &MeshSource, capacity: &Capacity) -> Result<Raw, SceneError>;

    /// Returns the other files that contain its data.
    fn others(&self) -> Vec<PathBuf>;
}

/// A file that was opened, whose parts can be read.
#[derive(Debug)]
pub(super) enum Opened {
    /// The whole contents.
    Whole(Box<Raw>),
    /// A file with parts.
    Parts(Box<dyn Parts>),
}

impl Opened {
    /// Opens a file in the format of its extension.
    pub(super) fn read(path: &Path, reading: Reading) -> Result<Self, SceneError> {
        let end = path.extension().map(|end| end.to_string_lossy().to_lowercase()).unwrap_or_default();
        let Some(format) = FORMATS.iter().find(|format| format.extensions.contains(&end.as_str())) else {
            let known: Vec<String> = FORMATS.iter().flat_map(|f| f.extensions).map(|end| format!(".{end}")).collect();
            let problem = format!("the name of a mesh file must end in {}", known.join(", "));
            return Err(SceneError::Mesh { path: path.to_owned(), problem });
        };
        let bytes = read_bytes(path)?;
        match format.read {
            Read::Whole(read) => Ok(Self::Whole(Box::new(read(&bytes, path, reading)?))),
            Read::Parts(read) => Ok(Self::Parts(read(bytes, path)?)),
        }
    }

    /// Returns the other files that contain its data.
    pub(super) fn others(&self) -> Vec<PathBuf> {
        match self {
            Self::Whole(_) => Vec::new(),
            Self::Parts(parts) => parts.others(),
        }
    }

    /// Returns the source of a part, and the map from the source to the file's scene.
    pub(super) fn find(&self, part: &MeshPart, path: &Path) -> Result<(MeshSource, DAffine3), SceneError> {
        match self {
            Self::Whole(_) if *part == MeshPart::default() => {
                Ok((MeshSource::Placed(part.clone()), DAffine3::IDENTITY))
            }
            Self::Whole(_) => {
                let problem = "this format has no nodes: remove `node` and `primitive`".to_owned();
                Err(SceneError::Mesh { path: path.to_owned(), problem })
            }
            Self::Parts(parts) => parts.find(part),
        }
    }

    /// Returns the mesh of a source; missing normals are generated with the crease angle `crease`.
    pub(super) fn mesh(
        &self,
        source: &MeshSource,
        crease: f64,
        path: &Path,
        capacity: &Capacity,
    ) -> Result<Mesh, SceneError> {
        match self {
            Self::Whole(raw) => raw.mesh(crease),
            Self::Parts(parts) => parts.read(source, capacity)?.mesh(crease),
        }
        .map_err(|flaw| flaw.of(path))
    }
}

impl Mesh {
    /// Creates a mesh from vertices, whose positions must not change later, and triangles.
    #[must_use]
    pub fn new(vertices: Vec<Vertex>, triangles: Vec<[u32; 3]>) -> Self {
        let cells = Cells::of(&vertices);
        let radius = cells.most(&vertices, DVec3::length).max(0.0);
        let inside = Inside::default();
        Self {
            vertices,
            triangles,
            colors: Vec::new(),
            origin: DVec3::ZERO,
            left_out: Vec::new(),
            color_flaw: None,
            cells,
            radius,
            inside,
        }
    }

    /// Returns the largest distance of a vertex from the origin.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Returns the largest value of a convex function at a vertex; −∞ without vertices.
    pub fn most(&self, value: impl Fn(DVec3) -> f64) -> f64 {
        self.cells.most(&self.vertices, value)
    }

    /// Returns the memory that the mesh takes, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        (size_of_val(&self.vertices[..]) + size_of_val(&self.triangles[..]) + size_of_val(&self.colors[..])) as u64
    }

    /// Reads a whole file in the format of its extension.
    ///
    /// # Errors
    ///
    /// Returns an error if the file cannot be read, its format is unknown or invalid, or it has no triangles.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let (stage, capacity) = (Stage::unwatched(), Capacity::default());
        let opened = Opened::read(path, Reading { stage: &stage, capacity: &capacity })?;
        let (source, _) = opened.find(&MeshPart::default(), path)?;
        opened.mesh(&source, MeshRequest::CREASE, path, &capacity)
    }

    /// Parses the text of an OBJ file; `path` names it in errors.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Diagnostics`] with every invalid line, or an error if the mesh has no triangles.
    pub fn parse(text: &str, path: &Path) -> Result<Self, SceneError> {
        let (stage, capacity) = (Stage::unwatched(), Capacity::default());
        obj::read(text, path, Reading { stage: &stage, capacity: &capacity })?
            .mesh(MeshRequest::CREASE)
            .map_err(|flaw| flaw.of(path))
    }
}
