//! The files that a scene names: each is loaded once, however often it is named.

use crate::scene::document::Node;
use crate::scene::document::reader::Reader;
use crate::scene::document::values::text;
use crate::scene::{Mesh, Picture, Profile, SceneError};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What was loaded; a file that failed is kept as a none, so that it is reported once.
pub struct Files {
    folder: PathBuf,
    pictures: Vec<Picture>,
    picture_of: HashMap<PathBuf, Option<usize>>,
    mesh_of: HashMap<PathBuf, Option<Arc<Mesh>>>,
    profile_of: HashMap<PathBuf, Option<Arc<Profile>>>,
}

impl Files {
    /// Names are relative to `folder`.
    pub fn new(folder: &Path) -> Self {
        Self {
            folder: folder.to_owned(),
            pictures: Vec::new(),
            picture_of: HashMap::new(),
            mesh_of: HashMap::new(),
            profile_of: HashMap::new(),
        }
    }

    /// All pictures, in the order that indices count.
    pub fn into_pictures(self) -> Vec<Picture> {
        self.pictures
    }

    /// The index of the picture that a node names.
    pub fn picture(&mut self, reader: &Reader, node: &Node) -> Option<usize> {
        let (path, identity) = self.find(reader, node)?;
        if let Some(known) = self.picture_of.get(&identity) {
            return *known;
        }
        let loaded = accept(reader, node, Picture::load(&path));
        let index = loaded.map(|picture| {
            self.pictures.push(picture);
            self.pictures.len() - 1
        });
        self.picture_of.insert(identity, index);
        index
    }

    /// The mesh that a node names.
    pub fn mesh(&mut self, reader: &Reader, node: &Node) -> Option<Arc<Mesh>> {
        let (path, identity) = self.find(reader, node)?;
        let load = || accept(reader, node, Mesh::load(&path)).map(Arc::new);
        self.mesh_of.entry(identity).or_insert_with(load).clone()
    }

    /// The profile that a node names.
    pub fn profile(&mut self, reader: &Reader, node: &Node) -> Option<Arc<Profile>> {
        let (path, identity) = self.find(reader, node)?;
        let load = || accept(reader, node, Profile::load(&path)).map(Arc::new);
        self.profile_of.entry(identity).or_insert_with(load).clone()
    }

    /// The path, and one that is the same for all names of the same file.
    fn find(&self, reader: &Reader, node: &Node) -> Option<(PathBuf, PathBuf)> {
        let path = self.folder.join(reader.accept(text(node))?);
        let identity = path.canonicalize().unwrap_or_else(|_| path.clone());
        Some((path, identity))
    }
}

/// Records an error: mistakes in the file with their own places, all else where the file was named.
pub fn accept<T>(reader: &Reader, node: &Node, loaded: Result<T, SceneError>) -> Option<T> {
    let error = match loaded {
        Ok(value) => return Some(value),
        Err(error) => error,
    };
    let help = match &error {
        SceneError::Read { .. } => "files are found relative to the scene file's folder",
        _ => "",
    };
    match error {
        SceneError::Mistakes(mistakes) => mistakes.into_iter().for_each(|m| reader.mistake(m)),
        error => reader.fault(node.fault(error.to_string(), help)),
    }
    None
}
