//! What formats of words share: words of a line, numbers, and what is wrong with them, each with its place.

use std::path::Path;

use crate::document::{Mistake, SceneError};

use super::raw::Raw;

/// A file with this many mistakes is read no further.
const ENOUGH: usize = 10;

/// What is wrong with a word of a text, and what would be right.
pub(super) type Wrong<'a> = (&'a str, String, String);

/// The mistakes of a text.
pub(super) struct Mistakes<'a> {
    text: &'a str,
    path: &'a Path,
    all: Vec<Mistake>,
}

impl<'a> Mistakes<'a> {
    pub fn of(text: &'a str, path: &'a Path) -> Self {
        Self { text, path, all: Vec::new() }
    }

    pub fn add(&mut self, (word, problem, help): Wrong<'a>) {
        self.all.push(Mistake::of(self.path, self.text, word, problem, help));
    }

    pub fn are_enough(&self) -> bool {
        self.all.len() >= ENOUGH
    }

    /// What was read, if nothing was wrong; `help` is what faces look like.
    pub fn or(mut self, raw: Raw, help: &str) -> Result<Raw, SceneError> {
        if self.all.is_empty() && raw.is_empty() {
            self.add((&self.text[..0], raw.nothing(), help.to_owned()));
        }
        if self.all.is_empty() { Ok(raw) } else { Err(self.error()) }
    }

    /// All of them.
    pub fn error(self) -> SceneError {
        SceneError::Mistakes(self.all)
    }
}

/// Returns `true` for a byte between words; a backslash is one too.
pub(super) fn divides(byte: u8) -> bool {
    byte.is_ascii_whitespace() || matches!(byte, b'\\' | 0x0B)
}

/// The words of a line.
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

/// The largest number of a mesh: beyond it squares of lengths overflow.
pub(super) const LARGEST: f32 = 1e30;

/// A number.
pub(super) fn number(word: &str) -> Result<f64, Wrong<'_>> {
    match word.parse::<f64>() {
        Ok(number) if (number as f32).abs() <= LARGEST => Ok(number),
        _ => Err((word, format!("expected a number, found `{word}`"), "numbers are finite, to 1e30".to_owned())),
    }
}

/// `N` numbers after a keyword; more are passed over.
pub(super) fn numbers<'a, const N: usize>(words: &[&'a str]) -> Result<[f64; N], Wrong<'a>> {
    let mut values = [0.0; N];
    for (i, value) in values.iter_mut().enumerate() {
        let Some(word) = words.get(i + 1) else {
            let problem = format!("`{}` needs {N} numbers, found {i}", words[0]);
            return Err((words[0], problem, String::new()));
        };
        *value = number(word)?;
    }
    Ok(values)
}
