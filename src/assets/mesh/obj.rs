//! OBJ: lines that begin with what they say.
//!
//! *Theory.* Four statements matter: `v`, `vt`, `vn` and `f`; all others (groups, materials, lines, points, smoothing)
//! are passed over.
//!
//! *Practice.* Every statement is read with its line, so that each mistake has its place. Words are found byte by byte and nothing is
//! allocated for a line: a million triangles take less than a second.

use std::path::Path;

use glam::{Vec2, Vec3};

use super::raw::{Corner, MOST_CORNERS, Raw, too_many};
use super::text::{Mistakes, Wrong, numbers, words};
use super::{Format, Read};
use crate::document::SceneError;
use crate::progress::Stage;

pub(super) const FORMAT: Format = Format {
    extensions: &["obj"],
    // Names and comments may be in any encoding; they do not matter here.
    read: Read::Whole(|bytes, path, stage| read(&String::from_utf8_lossy(bytes), path, stage)),
};

/// Reads the text of an OBJ file, and reports its bytes to `stage`; `path` names it in mistakes.
pub(super) fn read(text: &str, path: &Path, stage: &Stage) -> Result<Raw, SceneError> {
    let mut loader = Loader::default();
    let mut mistakes = Mistakes::of(text, path);
    let mut line = Vec::new();
    for statement in statements(text) {
        line.clear();
        line.extend(words(statement));
        stage.reach((statement.as_ptr() as usize - text.as_ptr() as usize) as f64);
        if let Err(wrong) = loader.statement(&line) {
            mistakes.add(wrong);
        }
        if mistakes.are_enough() {
            break;
        }
    }
    mistakes.or(loader.raw, "faces are lines such as `f 1 2 3`")
}

/// Lines without their comments; a line that ends in a backslash goes on in the next.
fn statements(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let mut end = 0;
        loop {
            let line_end = rest[end..].find('\n').map_or(rest.len(), |i| end + i + 1);
            let line = uncommented(&rest[end..line_end]);
            let continued = line.trim_ascii_end().ends_with('\\');
            end = line_end;
            if !continued || end == rest.len() {
                break;
            }
        }
        let (statement, after) = rest.split_at(end);
        rest = after;
        Some(uncommented(statement))
    })
}

fn uncommented(line: &str) -> &str {
    line.find('#').map_or(line, |comment| &line[..comment])
}

/// What has been read of a file.
#[derive(Default)]
struct Loader {
    raw: Raw,
    /// The corners of the face at hand.
    corners: Vec<Corner>,
}

impl Loader {
    fn statement<'a>(&mut self, words: &[&'a str]) -> Result<(), Wrong<'a>> {
        match words {
            // A wrong line still takes its number, so that the faces below it mean what they meant.
            ["v", ..] => push(&mut self.raw.positions, numbers(words).map(Vec3::from_array)),
            ["vn", ..] => push(&mut self.raw.normals, numbers(words).map(Vec3::from_array)),
            // A texture may have one coordinate only.
            ["vt", _] => push(&mut self.raw.uvs, numbers::<1>(words).map(|[u]| Vec2::new(u, 0.0))),
            ["vt", ..] => push(&mut self.raw.uvs, numbers(words).map(Vec2::from_array)),
            ["f", corners @ ..] => {
                self.corners.clear();
                for word in corners {
                    let corner = self.corner(word)?;
                    self.corners.push(corner);
                }
                if corners.len() > MOST_CORNERS {
                    let (problem, help) = too_many(corners.len());
                    return Err((words[0], problem, help));
                }
                // Some programs write points and lines as faces.
                if self.corners.len() > 2 {
                    self.raw.face(&self.corners);
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// `position/texture/normal`, the last two optional; from 1, or back from the last given so far.
    fn corner<'a>(&self, word: &'a str) -> Result<Corner, Wrong<'a>> {
        let index = |text: &str, count: usize, what: &str| -> Result<Option<u32>, Wrong<'a>> {
            if text.is_empty() {
                return Ok(None);
            }
            let index = match text.parse::<i64>() {
                Ok(i) if i < 0 => count.checked_sub(i.unsigned_abs() as usize),
                Ok(i) => usize::try_from(i - 1).ok(),
                Err(_) => None,
            };
            match index.filter(|i| *i < count) {
                Some(index) => Ok(Some(index as u32)),
                None => Err((
                    word,
                    format!("there is no {what} `{text}`"),
                    format!("{count} stand above this line, counted from 1"),
                )),
            }
        };
        let mut parts = word.split('/');
        let mut next = || parts.next().unwrap_or("");
        let position = index(next(), self.raw.positions.len(), "vertex")?;
        let uv = index(next(), self.raw.uvs.len(), "texture coordinate")?;
        let normal = index(next(), self.raw.normals.len(), "normal")?;
        let missing = || (word, "a corner needs a vertex".to_owned(), String::new());
        Ok(Corner::new(position.ok_or_else(missing)?, uv, normal))
    }
}

/// Adds a value, or zeros in place of one that is wrong.
fn push<'a, T: Default>(all: &mut Vec<T>, value: Result<T, Wrong<'a>>) -> Result<(), Wrong<'a>> {
    let (value, wrong) = match value {
        Ok(value) => (value, Ok(())),
        Err(wrong) => (T::default(), Err(wrong)),
    };
    all.push(value);
    wrong
}
