//! The images of a file: in separate files, or in its bytes.

use std::path::PathBuf;

use gltf_json::Texture;

use super::Gltf;
use crate::assets::format_error::FormatError;
use crate::document::SceneError;

/// The location of an image.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Stored {
    /// A separate file.
    Beside(PathBuf),
    /// Bytes in this file, in the format of a separate file.
    Within(Vec<u8>),
}

/// Returns the index of a texture's image, from the texture itself or else from an extension.
#[must_use]
pub fn image_of(texture: &Texture) -> Option<usize> {
    // `gltf-json` uses this number for a missing index.
    let own = Some(texture.source.value()).filter(|number| *number != u32::MAX as usize);
    own.or_else(|| {
        let extensions = texture.extensions.as_ref()?.others.values();
        let mut numbers = extensions.filter_map(|extension| extension.get("source")?.as_u64());
        numbers.find_map(|number| usize::try_from(number).ok())
    })
}

impl Gltf {
    /// Returns the image with this index.
    ///
    /// # Errors
    ///
    /// Returns an error if the file has no such image, or the data of the image cannot be read from a buffer or a data URI.
    pub fn image(&self, number: usize) -> Result<Stored, SceneError> {
        self.stored(number).map_err(|flaw| flaw.of(&self.path))
    }

    fn stored(&self, number: usize) -> Result<Stored, FormatError> {
        let of = format!("images[{number}]");
        let count = self.root.images.len();
        let image = self
            .root
            .images
            .get(number)
            .ok_or_else(|| FormatError(format!("{of} does not exist; the file has {count}")))?;
        match (&image.uri, image.buffer_view) {
            (Some(uri), _) => match self.beside(uri) {
                // Anything that is not a regular file may have no end.
                Some(path) if path.exists() && !path.is_file() => {
                    Err(FormatError(format!("{of} refers to `{}`, which is not a regular file", path.display())))
                }
                Some(path) => Ok(Stored::Beside(path)),
                None => self.resource(uri, &of).map(Stored::Within),
            },
            (None, Some(view)) => Ok(Stored::Within(self.view(view, &of)?.1.to_vec())),
            (None, None) => Err(FormatError(format!("{of} has neither `uri` nor `bufferView`"))),
        }
    }
}
