//! Shared code of text formats: words of a line, numbers, and errors with their locations.

use std::path::Path;

use crate::document::{Diagnostic, SceneError};

use super::raw::Raw;

/// The number of errors after which a file is not read further.
const ENOUGH: usize = 10;

/// An error at a word of a text: the word, the problem and the remedy.
pub(super) type Wrong<'a> = (&'a str, String, String);

/// The errors of a text.
pub(super) struct Diagnostics<'a> {
    text: &'a str,
    path: &'a Path,
    all: Vec<Diagnostic>,
}

impl<'a> Diagnostics<'a> {
    pub fn of(text: &'a str, path: &'a Path) -> Self {
        Self { text, path, all: Vec::new() }
    }

    pub fn add(&mut self, (word, problem, help): Wrong<'a>) {
        self.all.push(Diagnostic::of(self.path, self.text, word, problem, help));
    }

    pub fn are_enough(&self) -> bool {
        self.all.len() >= ENOUGH
    }

    /// Returns `raw` if there are no errors; `help` is an example of a face.
    pub fn or(mut self, raw: Raw, help: &str) -> Result<Raw, SceneError> {
        if self.all.is_empty() && raw.is_empty() {
            self.add((&self.text[..0], raw.nothing(), help.to_owned()));
        }
        if self.all.is_empty() { Ok(raw) } else { Err(self.error()) }
    }

    /// Returns all errors as one.
    pub fn error(self) -> SceneError {
        SceneError::Diagnostics(self.all)
    }
}

/// Returns `true` for a byte between words, including a backslash.
pub(super) fn divides(byte: u8) -> bool {
    byte.is_ascii_whitespace() || matches!(byte, b'\\' | 0x0B)
}

/// Returns the words of a line.
pub(super) fn words(line: &str) -> impl Iterator<Item = &str> {
    let mut rest = line;
    std::iter::from_fn(move || {
        let start = rest.bytes().position(|byte| !divides(byte))?;
        let end = rest.bytes().skip(start).position(divides).map_or(rest.len(), |length| start + length);
        let word = &rest[start..end];
        rest = &rest[end..];
        Some(word)
    })
}

/// The largest magnitude of a number in a mesh; squares of larger lengths would overflow.
pub(super) const LARGEST: f32 = 1e30;

/// Parses a number.
pub(super) fn number(word: &str) -> Result<f64, Wrong<'_>> {
    match word.parse::<f64>() {
        Ok(number) if (number as f32).abs() <= LARGEST => Ok(number),
        _ => Err((
            word,
            format!("expected a number, found `{word}`"),
            "numbers must be finite, up to 1e30 in magnitude".to_owned(),
        )),
    }
}

/// Parses `N` numbers after a keyword; additional words are ignored.
pub(super) fn numbers<'a, const N: usize>(words: &[&'a str]) -> Result<[f64; N], Wrong<'a>> {
    let mut values = [0.0; N];
    for (i, value) in values.iter_mut().enumerate() {
        let Some(word) = words.get(i + 1) else {
            let problem = format!("`{}` requires {N} numbers, found {i}", words[0]);
            return Err((words[0], problem, String::new()));
        };
        *value = number(word)?;
    }
    Ok(values)
}
