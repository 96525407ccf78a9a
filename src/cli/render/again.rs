//! The line that repeats a render.

use std::path::PathBuf;

use super::Arguments;
use crate::cli::share::Target;
use crate::cli::words::{quoted, typed};

/// Options that only say how a picture came about in steps.
const STEPS: [&str; 3] = ["--continue", "--preview", "--preview-every"];
/// And how that is told.
const TOLD: [&str; 1] = ["--json"];

impl Arguments {
    /// What to type for the same files: what was typed, without what only led to them in steps. Where the method was not named it is that
    /// of the first file that stays: of a film without files for its frames it is found again.
    pub(super) fn again(&self, is_found: bool, first: Target) -> String {
        let stays = |path: &PathBuf| self.frame_folder().is_none_or(|folder| !path.starts_with(folder));
        let file = self.paths(first).into_iter().find(stays).filter(|_| is_found);
        let method = file.into_iter().flat_map(|path| ["--method-from".to_owned(), path.display().to_string()]);
        let words: Vec<String> =
            ["bentray".to_owned()].into_iter().chain(typed(1, &STEPS, &TOLD)).chain(method).collect();
        quoted(&words)
    }
}
