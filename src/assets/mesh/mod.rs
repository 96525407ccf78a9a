//! Meshes: files as triangles with positions, normals and texture coordinates.
//!
//! *Theory.* A file gives corners of faces, and perhaps normals. Faces may be any simple polygons; [`Raw`] cuts them to triangles.
//! Normals that a file lacks are made where its faces meet at less than a crease's angle, and are the face's own elsewhere.
//!
//! *Practice.* [`FORMATS`] names each format once, by the ends of its files' names. Adding one is a file here and a line of that
//! table. A reader believes no count before it has seen as many bytes, and goes no
//! further once there are more triangles than the [`Capacity`] has room for. Triangles without area are dropped, and equal corners
//! share a vertex.

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

/// Triangles in a space of their own: that of the file, moved by [`Mesh::origin`] where the file's coordinates are large.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Corners, each used by at least one triangle.
    pub vertices: Vec<Vertex>,
    /// Indices into the vertices, counter-clockwise seen from outside if the file winds them so; [`Mesh::solids`] always are.
    pub triangles: Vec<[u32; 3]>,
    /// The linear color of each vertex, its components from 0 to 1; empty if the file has none.
    pub colors: Vec<Vec3>,
    /// The point of the file's space at which the mesh's own space has its origin: positions in the file are `origin + position`.
    /// It is zero along each axis on which the file's origin is nearer than the mesh is large.
    pub origin: DVec3,
    /// The elements of the file that are not drawn, such as `lines (3)`.
    pub left_out: Vec<String>,
    /// What is wrong with the file's colors, if they cannot be used.
    color_flaw: Option<String>,
    /// The vertices, as [`Mesh::new`] had them.
    cells: Cells,
    radius: f64,
    inside: Inside,
}

/// A corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// In the mesh's own space.
    pub position: Vec3,
    /// Unit vector.
    pub normal: Vec3,
    /// Texture coordinates; (0, 0) if the file has none.
    pub uv: Vec2,
}

/// What is wanted of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// The angle in degrees at which faces meet in an edge that is seen, where the file has no normals.
    pub crease: f64,
    /// Which part of the file.
    pub part: Part,
}

/// A part of a file that has several.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash)]
pub struct Part {
    /// The node whose mesh it is; all nodes without one.
    pub node: Option<NodeName>,
    /// Which of the mesh's primitives, counted from 0; all without one.
    pub primitive: Option<u32>,
}

/// Where triangles are read from: what several nodes of a file show is the same.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Source {
    /// A part of a file, in its place there.
    Placed(Part),
    /// A mesh of a file in its own space.
    Own {
        /// Its place in the file's list of meshes.
        mesh: usize,
        /// Which of its primitives, counted from 0; all without one.
        primitive: Option<u32>,
    },
}

impl Wanted {
    /// The crease's angle where nobody says it: smaller than between the faces of anything that has edges, larger than between
    /// those of what is meant to be round.
    pub const CREASE: f64 = 30.0;
}

impl Default for Wanted {
    fn default() -> Self {
        Self { crease: Self::CREASE, part: Part::default() }
    }
}

/// A format of files.
struct Format {
    /// The ends of its files' names.
    extensions: &'static [&'static str],
    read: Read,
}

/// How a file is read.
enum Read {
    /// All of it is one mesh.
    Whole(fn(&[u8], &Path, Reading) -> Result<Raw, SceneError>),
    /// It has parts, to be asked for one by one.
    Parts(fn(Vec<u8>, &Path) -> OpenedParts),
}

/// What reading a file goes along with.
#[derive(Clone, Copy)]
pub(super) struct Reading<'a> {
    /// Where the bytes that are read are reported.
    pub stage: &'a Stage,
    /// The number of triangles that there may be.
    pub capacity: &'a Capacity,
}

type OpenedParts = Result<Box<dyn Parts>, SceneError>;

/// Every format. Adding one is a line here.
const FORMATS: [&Format; 4] = [&obj::FORMAT, &ply::FORMAT, &stl::FORMAT, &gltf::FORMAT];

/// What is known of a file that has parts.
pub(super) trait Parts: std::fmt::Debug + Send + Sync {
    /// Where one of them is read from, and the map from there to its place.
    fn find(&self, part: &Part) -> Result<(Source, DAffine3), SceneError>;

    /// The triangles there, if they are not more than there may be.
    fn read(&self, source: &Source, capacity: &Capacity) -> Result<Raw, SceneError>;

    /// The other files that it is in.
    fn others(&self) -> Vec<PathBuf>;
}

/// A file that was read, of which parts can be had.
#[derive(Debug)]
pub(super) enum Opened {
    /// All that there is.
    Whole(Box<Raw>),
    /// Its parts.
    Parts(Box<dyn Parts>),
}

impl Opened {
    /// Reads a file, by the format that the end of its name tells.
    pub(super) fn read(path: &Path, reading: Reading) -> Result<Self, SceneError> {
        let end = path.extension().map(|end| end.to_string_lossy().to_lowercase()).unwrap_or_default();
        let Some(format) = FORMATS.iter().find(|format| format.extensions.contains(&end.as_str())) else {
            let known: Vec<String> = FORMATS.iter().flat_map(|f| f.extensions).map(|end| format!(".{end}")).collect();
            let problem = format!("meshes are files whose names end in {}", known.join(", "));
            return Err(SceneError::Mesh { path: path.to_owned(), problem });
        };
        let bytes = read_bytes(path)?;
        match format.read {
            Read::Whole(read) => Ok(Self::Whole(Box::new(read(&bytes, path, reading)?))),
            Read::Parts(read) => Ok(Self::Parts(read(bytes, path)?)),
        }
    }

    /// The other files that it is in.
    pub(super) fn others(&self) -> Vec<PathBuf> {
        match self {
            Self::Whole(_) => Vec::new(),
            Self::Parts(parts) => parts.others(),
        }
    }

    /// Where a part is read from, and the map from there to its place.
    pub(super) fn find(&self, part: &Part, path: &Path) -> Result<(Source, DAffine3), SceneError> {
        match self {
            Self::Whole(_) if *part == Part::default() => Ok((Source::Placed(part.clone()), DAffine3::IDENTITY)),
            Self::Whole(_) => {
                let problem = "it has no nodes: leave `node` and `primitive` out".to_owned();
                Err(SceneError::Mesh { path: path.to_owned(), problem })
            }
            Self::Parts(parts) => parts.find(part),
        }
    }

    /// The triangles there, with normals as `crease` says where the file has none.
    pub(super) fn mesh(
        &self,
        source: &Source,
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
    /// Of vertices, whose places do not change any more.
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

    /// The greatest distance of a vertex from the origin.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The largest value of a convex function at a vertex; −∞ without one.
    pub fn most(&self, value: impl Fn(DVec3) -> f64) -> f64 {
        self.cells.most(&self.vertices, value)
    }

    /// What it takes of memory.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        (size_of_val(&self.vertices[..]) + size_of_val(&self.triangles[..]) + size_of_val(&self.colors[..])) as u64
    }

    /// Reads all of a file; the end of its name says how.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let (stage, capacity) = (Stage::unwatched(), Capacity::default());
        let opened = Opened::read(path, Reading { stage: &stage, capacity: &capacity })?;
        let (source, _) = opened.find(&Part::default(), path)?;
        opened.mesh(&source, Wanted::CREASE, path, &capacity)
    }

    /// Reads the text of an OBJ file; `path` names it in mistakes.
    pub fn parse(text: &str, path: &Path) -> Result<Self, SceneError> {
        let (stage, capacity) = (Stage::unwatched(), Capacity::default());
        obj::read(text, path, Reading { stage: &stage, capacity: &capacity })?
            .mesh(Wanted::CREASE)
            .map_err(|flaw| flaw.of(path))
    }
}
