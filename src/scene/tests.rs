//! Tests of valid and invalid scenes as users write them.

mod animation;
mod attacked;
mod capacity;
mod colors;
mod cut;
mod encodings;
mod files;
mod formats;
mod gltf;
mod inside;
mod large;
mod mistakes;
mod normals;
mod overrides;
mod pictures;
mod profiles;
mod properties;
mod rounding;
mod scenes;
mod shells;
mod synonyms;
mod touching;
mod units;

use super::{Diagnostic, Override, Scene, SceneError};
use std::path::Path;

/// The minimum that every scene needs.
const RAYS: &str = "[rays]\nbounding_sphere = { radius = 10 }\n";

fn parse(text: &str) -> Result<Scene, SceneError> {
    Scene::parse(text, Path::new("scene.toml"), &[])
}

fn good(text: &str) -> Scene {
    parse(text).unwrap_or_else(|e| panic!("{text}\n{e}"))
}

fn mistakes_of(result: Result<Scene, SceneError>) -> Vec<Diagnostic> {
    match result {
        Err(SceneError::Diagnostics(mistakes)) => mistakes,
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("no error found"),
    }
}

/// Returns the only error of a text in which «» mark its expected location.
fn marked(text: &str) -> Diagnostic {
    let start = text.find('«').expect("a mark");
    let end = text.find('»').expect("a mark") - '«'.len_utf8();
    let text = text.replace(['«', '»'], "");
    let mistakes = mistakes_of(parse(&text));
    let [mistake] = &mistakes[..] else {
        panic!("{text}\n{}", SceneError::Diagnostics(mistakes));
    };
    let above = &text[..start];
    assert_eq!(mistake.line, above.split('\n').count(), "{mistake}");
    let line = above.rsplit('\n').next().unwrap_or("");
    assert_eq!(mistake.column, line.chars().count() + 1, "{mistake}");
    assert_eq!(mistake.excerpt, text[start..end], "{mistake}");
    mistake.clone()
}
