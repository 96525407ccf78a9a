//! The pictures of a file: beside it, or in its bytes.

use std::path::PathBuf;

use gltf_json::Texture;

use super::Gltf;
use crate::assets::flaw::Flaw;
use crate::document::SceneError;

/// Where a picture is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Stored {
    /// In a file of its own.
    Beside(PathBuf),
    /// In the file's bytes, as a file of its own would have it.
    Within(Vec<u8>),
}

/// Returns the number of a texture's image: its own, or one that an extension gives it for want of that.
#[must_use]
pub fn image_of(texture: &Texture) -> Option<usize> {
    // `gltf-json` has this number for one that is not there.
    let own = Some(texture.source.value()).filter(|number| *number != u32::MAX as usize);
    own.or_else(|| {
        let extensions = texture.extensions.as_ref()?.others.values();
        let mut numbers = extensions.filter_map(|extension| extension.get("source")?.as_u64());
        numbers.find_map(|number| usize::try_from(number).ok())
    })
}

impl Gltf {
    /// The picture of this number.
    pub fn image(&self, number: usize) -> Result<Stored, SceneError> {
        self.stored(number).map_err(|flaw| flaw.of(&self.path))
    }

    fn stored(&self, number: usize) -> Result<Stored, Flaw> {
        let of = format!("images[{number}]");
        let count = self.root.images.len();
        let image = self.root.images.get(number).ok_or_else(|| Flaw(format!("there is no {of}; there are {count}")))?;
        match (&image.uri, image.buffer_view) {
            (Some(uri), _) => match self.beside(uri) {
                // What is no file may have no end.
                Some(path) if path.exists() && !path.is_file() => {
                    Err(Flaw(format!("{of}: `{}` is not a file", path.display())))
                }
                Some(path) => Ok(Stored::Beside(path)),
                None => self.resource(uri, &of).map(Stored::Within),
            },
            (None, Some(view)) => Ok(Stored::Within(self.view(view, &of)?.1.to_vec())),
            (None, None) => Err(Flaw(format!("{of} has neither `uri` nor `bufferView`"))),
        }
    }
}
