//! The files that scenes name: each is loaded once, however often it is named.
//!
//! *Length.* Over 300 lines, because each kind of file has a cache of the same form here.

use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::DAffine3;

use super::GridUse;
use super::mesh::{Opened, Reading};
use super::{Capacity, Catalog, Mesh, MeshPart, MeshRequest, MeshSource, Picture, Profile, SampledGrid};
use crate::document::Node;
use crate::document::reader::Reader;
use crate::document::values::text;
use crate::document::{SceneError, read_text};
use crate::progress::{Progress, Stage};

/// A mesh, and the map from object space to the file's scene.
type PlacedMesh = (Arc<Mesh>, DAffine3);

/// The parts that were requested of a mesh file, and the meshes that were read for them. Crease angles are compared by their bits.
#[derive(Debug, Default)]
struct Meshes {
    wanted: HashMap<(MeshPart, u64), Option<PlacedMesh>>,
    read: HashMap<(MeshSource, u64), Arc<Mesh>>,
}

/// The files that were loaded, for one scene or for several that share them, such as the frames of an animation. Within a scene a file
/// that failed is stored as `None`, so that the error is reported once.
#[derive(Debug, Default)]
pub struct Files {
    /// The progress to which the reading of files is reported.
    progress: Progress,
    /// The number of bytes of memory that meshes, images and grids may take; `None` for no limit.
    limit: Option<u64>,
    /// The limit on the triangles of a mesh.
    capacity: Capacity,
    /// The images of the scene, by index.
    pictures: Vec<(PathBuf, Picture)>,
    picture_of: HashMap<PathBuf, Option<Picture>>,
    /// The requested parts of each mesh file.
    meshes_of: HashMap<PathBuf, Meshes>,
    /// The files that mesh and grid files name.
    others: BTreeSet<PathBuf>,
    /// The elements in the scene's meshes that are not drawn, as a sentence for each file.
    left_out: BTreeSet<String>,
    /// The file of the last mesh; objects often use its parts one after the other.
    opened: Option<(PathBuf, Opened)>,
    profile_of: HashMap<PathBuf, Option<Arc<Profile>>>,
    catalog_of: HashMap<PathBuf, Option<Arc<Catalog>>>,
    text_of: HashMap<PathBuf, Option<Arc<str>>>,
    grid_of: HashMap<PathBuf, (GridUse, Arc<SampledGrid>)>,
}

/// The memory limit for files, and the memory that the loaded files leave.
#[derive(Debug, Clone, Copy)]
struct Room {
    limit: u64,
    left: u64,
}

impl Room {
    /// Loads a file that takes at least `least` bytes; `taken` returns the bytes of the result.
    fn load<T>(
        self,
        path: &Path,
        least: u64,
        load: impl FnOnce() -> Result<T, SceneError>,
        taken: impl Fn(&T) -> u64,
    ) -> Result<T, SceneError> {
        let Self { limit, left } = self;
        let too_much = |needed: u64| SceneError::Memory { path: path.to_owned(), needed, left, limit };
        let fits = |needed: u64| if needed <= left { Ok(()) } else { Err(too_much(needed)) };
        fits(least)?;
        let loaded = load()?;
        fits(taken(&loaded))?;
        Ok(loaded)
    }
}

/// Returns the length of a file, which is the least memory that it takes while it is read.
fn length(path: &Path) -> u64 {
    std::fs::metadata(path).map_or(0, |file| file.len())
}

impl Files {
    /// Limits the memory of loaded files to `limit` bytes; larger files are rejected, before they are read if their size is known.
    #[must_use]
    pub fn within(self, limit: u64) -> Self {
        Self { limit: Some(limit), ..self }
    }

    /// Rejects meshes with more triangles than this, as soon as their number is known.
    #[must_use]
    pub fn holding(self, capacity: Capacity) -> Self {
        Self { capacity, ..self }
    }

    /// Reports the files that are read to `progress`.
    #[must_use]
    pub fn reporting(self, progress: Progress) -> Self {
        Self { progress, ..self }
    }

    /// Opens the stage of reading a file, whose units are its bytes.
    fn reading(&self, path: &Path) -> Stage {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        self.progress.measured(format!("reading {name}"), length(path) as f64)
    }

    fn room(&self) -> Room {
        let pictures = self.picture_of.values().flatten().map(Picture::bytes);
        let meshes = self.meshes_of.values().flat_map(|file| file.read.values()).map(|mesh| mesh.bytes());
        let grids = self.grid_of.values().map(|(_, grid)| grid.bytes());
        let catalogs = self.catalog_of.values().flatten().map(|catalog| catalog.bytes());
        let limit = self.limit.unwrap_or(u64::MAX);
        Room { limit, left: limit.saturating_sub(pictures.chain(meshes).chain(grids).chain(catalogs).sum()) }
    }

    /// Continues with another scene: files that failed before are tried again.
    pub fn begin(&mut self) {
        self.pictures.clear();
        self.left_out.clear();
        self.picture_of.retain(|_, loaded| loaded.is_some());
        self.meshes_of.retain(|_, file| {
            file.wanted.retain(|_, loaded| loaded.is_some());
            !file.wanted.is_empty()
        });
        self.opened = None;
        self.profile_of.retain(|_, loaded| loaded.is_some());
        self.catalog_of.retain(|_, loaded| loaded.is_some());
        self.text_of.retain(|_, loaded| loaded.is_some());
    }

    /// Returns every file that was loaded, sorted.
    #[must_use]
    pub fn paths(&self) -> Vec<PathBuf> {
        let pictures = self.picture_of.keys().chain(self.meshes_of.keys()).chain(self.profile_of.keys());
        let pictures = pictures.chain(self.catalog_of.keys());
        let mut all: Vec<PathBuf> =
            pictures.chain(self.text_of.keys()).chain(self.grid_of.keys()).chain(&self.others).cloned().collect();
        all.sort();
        all
    }

    /// Returns all images of the scene, by index.
    #[must_use]
    pub fn pictures(&self) -> Vec<Picture> {
        self.pictures.iter().map(|(_, picture)| picture.clone()).collect()
    }

    /// Returns the elements in the scene's files that are not drawn, as a sentence for each file.
    #[must_use]
    pub fn left_out(&self) -> Vec<String> {
        self.left_out.iter().cloned().collect()
    }

    /// Returns the index of the image that a node names.
    pub fn picture(&mut self, reader: &Reader, node: &Node) -> Option<usize> {
        let (path, identity) = find(reader, node)?;
        if let Some(known) = self.pictures.iter().position(|(of, _)| *of == identity) {
            return Some(known);
        }
        let (room, stage) = (self.room(), self.reading(&path));
        let load = || {
            let load = || Picture::read(&path, &stage);
            accept(reader, node, room.load(&path, Picture::bytes_of(&path), load, Picture::bytes))
        };
        let picture = self.picture_of.entry(identity.clone()).or_insert_with(load).clone()?;
        self.pictures.push((identity, picture));
        Some(self.pictures.len() - 1)
    }

    /// Returns the text that a node names, and its name in errors.
    pub fn text(&mut self, reader: &Reader, node: &Node) -> Option<(String, Arc<str>)> {
        let (path, identity) = find(reader, node)?;
        let load = || accept(reader, node, read_text(&path)).map(Arc::from);
        let text = self.text_of.entry(identity).or_insert_with(load).clone()?;
        Some((path.display().to_string(), text))
    }

    /// Returns the requested part of the mesh file that a node names, and the map from object space to the file's scene.
    /// `part` is the node that names the part, for errors about it.
    pub fn mesh(&mut self, reader: &Reader, node: &Node, part: &Node, wanted: &MeshRequest) -> Option<PlacedMesh> {
        let (path, identity) = find(reader, node)?;
        let placed = self.placed_mesh(reader, (node, part), wanted, (&path, identity))?;
        if !placed.0.left_out.is_empty() {
            let kinds = placed.0.left_out.join(", ");
            self.left_out.insert(format!("{}: ignored {kinds}; only triangles are drawn", path.display()));
        }
        Some(placed)
    }

    fn placed_mesh(
        &mut self,
        reader: &Reader,
        (node, part): (&Node, &Node),
        wanted: &MeshRequest,
        (path, identity): (&Path, PathBuf),
    ) -> Option<PlacedMesh> {
        let key = (wanted.part.clone(), wanted.crease.to_bits());
        let known = self.meshes_of.get(&identity).map(|file| &file.wanted);
        if let Some(found) = known.and_then(|wanted| wanted.get(&key)) {
            return found.clone();
        }
        // An error in a file is reported once, whatever part was requested.
        if self.opened.as_ref().is_none_or(|(before, _)| *before != identity)
            && known.is_some_and(|wanted| !wanted.is_empty() && wanted.values().all(Option::is_none))
        {
            return None;
        }
        let opened = accept(reader, node, self.open_meshes(path, &identity));
        let found = opened.and_then(|opened| accept(reader, part, opened.find(&wanted.part, path)));
        let placed = found.and_then(|(source, place)| {
            let mesh = accept(reader, node, self.read_mesh(path, &identity, source, wanted.crease))?;
            let place = place * DAffine3::from_translation(mesh.origin);
            Some((mesh, place))
        });
        self.meshes_of.entry(identity).or_default().wanted.insert(key, placed.clone());
        placed
    }

    fn open_meshes(&mut self, path: &Path, identity: &Path) -> Result<&Opened, SceneError> {
        let opened = if let Some((_, opened)) = self.opened.take().filter(|(before, _)| before == identity) {
            opened
        } else {
            let stage = self.reading(path);
            let reading = Reading { stage: &stage, capacity: &self.capacity };
            self.room().load(path, length(path), || Opened::read(path, reading), |_| 0)?
        };
        self.others.extend(opened.others());
        Ok(&self.opened.insert((identity.to_owned(), opened)).1)
    }

    fn read_mesh(
        &mut self,
        path: &Path,
        identity: &Path,
        source: MeshSource,
        crease: f64,
    ) -> Result<Arc<Mesh>, SceneError> {
        let key = (source, crease.to_bits());
        let known = self.meshes_of.get(identity).and_then(|file| file.read.get(&key));
        if let Some(mesh) = known {
            return Ok(Arc::clone(mesh));
        }
        let room = self.room();
        let (progress, capacity) = (self.progress.clone(), self.capacity.clone());
        let opened = self.open_meshes(path, identity)?;
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let _stage = progress.stage(format!("building the mesh of {name}"));
        let mesh = Arc::new(room.load(path, 0, || opened.mesh(&key.0, crease, path, &capacity), Mesh::bytes)?);
        self.meshes_of.entry(identity.to_owned()).or_default().read.insert(key, Arc::clone(&mesh));
        Ok(mesh)
    }

    /// Returns the profile that a node names.
    pub fn profile(&mut self, reader: &Reader, node: &Node) -> Option<Arc<Profile>> {
        let (path, identity) = find(reader, node)?;
        let load = || accept(reader, node, Profile::load(&path)).map(Arc::new);
        self.profile_of.entry(identity).or_insert_with(load).clone()
    }

    /// Returns the star catalog that a node names.
    pub fn catalog(&mut self, reader: &Reader, node: &Node) -> Option<Arc<Catalog>> {
        let (path, identity) = find(reader, node)?;
        let (room, _stage) = (self.room(), self.reading(&path));
        let load = || {
            let load = || Catalog::load(&path);
            accept(reader, node, room.load(&path, length(&path), load, Catalog::bytes)).map(Arc::new)
        };
        self.catalog_of.entry(identity).or_insert_with(load).clone()
    }

    /// Returns the grid that a node names, used as `used` specifies.
    pub fn grid(&mut self, reader: &Reader, node: &Node, used: &GridUse) -> Option<Arc<SampledGrid>> {
        let (path, identity) = find(reader, node)?;
        if let Some((_, grid)) = self.grid_of.get(&identity).filter(|(before, _)| before == used) {
            return Some(Arc::clone(grid));
        }
        // A grid that was used differently is not kept in addition.
        self.grid_of.remove(&identity);
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let stage = self.progress.measured(format!("reading {name}"), 1.0);
        let load = || SampledGrid::read(&path, used, &stage);
        let grid = Arc::new(accept(reader, node, self.room().load(&path, length(&path), load, SampledGrid::bytes))?);
        self.others.extend(grid.data.clone());
        self.grid_of.insert(identity, (*used, Arc::clone(&grid)));
        Some(grid)
    }
}

/// Returns the path, relative to the scene file's folder, and a path that is equal for all names of the same file.
fn find(reader: &Reader, node: &Node) -> Option<(PathBuf, PathBuf)> {
    let path = reader.folder().join(reader.accept(text(node))?);
    let identity = path.canonicalize().unwrap_or_else(|_| path.clone());
    Some((path, identity))
}

/// Records an error: errors in the file at their locations, all others at the node that names the file.
fn accept<T>(reader: &Reader, node: &Node, loaded: Result<T, SceneError>) -> Option<T> {
    let error = match loaded {
        Ok(value) => return Some(value),
        Err(error) => error,
    };
    let help = match &error {
        SceneError::Read { source, .. } if source.kind() == std::io::ErrorKind::NotFound => {
            "file names are relative to the folder of the scene file"
        }
        SceneError::Memory { .. } => "reduce its size, or raise the limit with --memory",
        _ => "",
    };
    match error {
        SceneError::Diagnostics(mistakes) => mistakes.into_iter().for_each(|m| reader.mistake(m)),
        error => reader.fault(node.fault(error.to_string(), help)),
    }
    None
}
