//! The command line that repeats a render.

use std::path::PathBuf;

use super::Arguments;
use crate::cli::share::Target;
use crate::cli::words::{quoted, typed};

/// Options that only affect the steps in which an image is made.
const STEPS: [&str; 3] = ["--continue", "--preview", "--preview-every"];
/// Options that only affect the output format of the results.
const TOLD: [&str; 1] = ["--json"];

impl Arguments {
    /// Returns the command line for identical files: the typed one, without the options that only affect steps. If the method was not
    /// given, it is taken from the first file that stays; for a video without files of its frames, the search is repeated.
    pub(super) fn again(&self, is_found: bool, first: Target) -> String {
        let stays = |path: &PathBuf| self.frame_folder().is_none_or(|folder| !path.starts_with(folder));
        let file = self.paths(first).into_iter().find(stays).filter(|_| is_found);
        let method = file.into_iter().flat_map(|path| ["--method-from".to_owned(), path.display().to_string()]);
        let words: Vec<String> =
            ["bentray".to_owned()].into_iter().chain(typed(1, &STEPS, &TOLD)).chain(method).collect();
        quoted(&words)
    }
}
