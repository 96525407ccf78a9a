//! The errors of a scene.

use std::path::Path;

use serde_json::{Value, json};

use crate::cli::format::{CommandResult, shown};
use crate::document::brief;
use crate::error::Error;
use crate::scene::{Diagnostic, SceneError};

/// A scene that cannot be rendered.
pub(super) struct InvalidScene<'a> {
    pub path: &'a Path,
    pub error: Error,
}

impl CommandResult for InvalidScene<'_> {
    fn text(&self) -> String {
        format!("error: {}", self.error)
    }

    fn json(&self) -> Value {
        let error = match &self.error {
            Error::Frame { error, .. } => error,
            error => error,
        };
        let mistakes = match error {
            Error::Scene(SceneError::Diagnostics(mistakes)) => mistakes.iter().map(object).collect(),
            // The error concerns the whole scene, or a file that it names.
            error => {
                let file = match error {
                    Error::Scene(
                        SceneError::Read { path, .. }
                        | SceneError::Picture { path, .. }
                        | SceneError::Mesh { path, .. }
                        | SceneError::Grid { path, .. },
                    ) => path,
                    _ => self.path,
                };
                vec![json!({
                    "file": shown(file),
                    "line": null,
                    "column": null,
                    "excerpt": null,
                    "problem": self.error.to_string(),
                    "help": null,
                })]
            }
        };
        json!({ "scene": shown(self.path), "errors": mistakes })
    }
}

fn object(mistake: &Diagnostic) -> Value {
    let some = |text: &str| (!text.is_empty()).then(|| brief(text).into_owned());
    json!({
        "file": shown(&mistake.file),
        "line": mistake.line,
        "column": mistake.column,
        "excerpt": some(&mistake.excerpt),
        "problem": brief(&mistake.problem),
        "help": some(&mistake.help),
    })
}
