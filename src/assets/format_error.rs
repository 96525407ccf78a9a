//! Errors in files without lines.

use std::path::Path;

use crate::document::SceneError;

/// An error in a mesh whose format has no lines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct FormatError(pub String);

impl FormatError {
    /// Creates an error at a byte, counted from 0.
    pub fn at(byte: usize, problem: &str) -> Self {
        Self(format!("at byte {byte}: {problem}"))
    }

    pub fn of(self, path: &Path) -> SceneError {
        SceneError::Mesh { path: path.to_owned(), problem: self.0 }
    }
}

/// Returns `true` for bytes that a writer, or a transfer, may append to a file: zeros and blanks.
pub(in crate::assets) fn are_padding(bytes: &[u8]) -> bool {
    bytes.iter().all(|byte| byte.is_ascii_whitespace() || *byte == 0)
}
