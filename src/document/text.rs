//! Files that are text.

use std::path::Path;

use super::{Mistake, SceneError};

/// Reads a file whole, which must be text in UTF-8.
pub fn read_text(path: &Path) -> Result<String, SceneError> {
    let bytes = std::fs::read(path).map_err(|source| SceneError::Read { path: path.to_owned(), source })?;
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        // What stands for the byte that is none of UTF-8 is three bytes long, and begins where that did.
        let text = String::from_utf8_lossy(error.as_bytes());
        let (problem, help) = ("this byte is no text in UTF-8".to_owned(), "save the file as UTF-8".to_owned());
        SceneError::Mistakes(vec![Mistake::locate(path.to_owned(), &text, at, at + 3, problem, help)])
    })
}
