//! OBJ: lines that begin with a keyword.
//!
//! *Theory.* Four statements matter: `v`, `vt`, `vn` and `f`. Three or more numbers after the coordinates of a `v` begin
//! with a color; a single one is the weight of free-form geometry. Statements about groups, materials and smoothing are
//! ignored; points, lines and free-form curves are counted, so that the user learns that they are not drawn. A comment
//! begins at a `#` at the start of a line or after a blank: some programs write an invalid number as `-1.#IND`.
//!
//! *Practice.* Every statement is read with its line, so each error has a location. Words are found byte by byte without
//! allocation per line: a million triangles take less than a second.

use std::path::Path;

use glam::{DVec3, Vec2};

use super::raw::{Corner, MOST_CORNERS, Raw, too_many};
use super::text::{Diagnostics, Wrong, divides, numbers, words};
use super::{Format, Read, Reading};
use crate::document::values::suggest;
use crate::document::{SceneError, lenient_text};

pub(super) const FORMAT: Format = Format {
    extensions: &["obj"],
    // Names and comments may be in any encoding; they are not used.
    read: Read::Whole(|bytes, path, reading| read(&lenient_text(bytes, path)?, path, reading)),
};

/// Reads the text of an OBJ file; `path` names it in errors.
pub(super) fn read(text: &str, path: &Path, reading: Reading) -> Result<Raw, SceneError> {
    let mut loader = Loader::default();
    let mut mistakes = Diagnostics::of(text, path);
    let mut line = Vec::new();
    for statement in statements(text) {
        line.clear();
        line.extend(words(statement));
        reading.stage.reach((statement.as_ptr() as usize - text.as_ptr() as usize) as f64);
        if let Err(wrong) = loader.statement(&line) {
            mistakes.add(wrong);
        }
        if mistakes.are_enough() {
            break;
        }
        reading.capacity.check(loader.raw.triangles().len() as u64).map_err(|flaw| flaw.of(path))?;
    }
    mistakes.or(loader.raw, "faces are lines such as `f 1 2 3`")
}

/// Returns the lines without their comments; a line that ends in a backslash continues in the next.
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
    let follows_blank = |at: usize| at == 0 || divides(line.as_bytes()[at - 1]);
    let comment = line.match_indices('#').map(|(at, _)| at).find(|at| follows_blank(*at));
    comment.map_or(line, |comment| &line[..comment])
}

/// Keywords of the specification that do not change the triangles: free-form geometry, its vertices and bodies, groups,
/// materials, display and rendering attributes.
const WITHOUT_EFFECT: &str = "vp cstype deg bmat step parm trim hole scrv sp end con g s mg o bevel c_interp d_interp lod \
                             usemtl mtllib usemap maplib shadow_obj trace_obj ctech stech csh";
/// Keywords of geometry that is not drawn, with the name of the geometry.
const NOT_DRAWN: &[(&str, &str)] = &[
    ("p", "points"),
    ("l", "lines"),
    ("curv", "free-form curves"),
    ("curv2", "free-form curves"),
    ("surf", "free-form surfaces"),
    ("bsp", "free-form surfaces"),
    ("bzp", "free-form surfaces"),
    ("cdc", "free-form curves"),
    ("cdp", "free-form surfaces"),
    ("res", "free-form surfaces"),
];

/// The state of reading a file.
#[derive(Default)]
struct Loader {
    raw: Raw,
    /// The corners of the current face.
    corners: Vec<Corner>,
}

impl Loader {
    fn statement<'a>(&mut self, words: &[&'a str]) -> Result<(), Wrong<'a>> {
        match words {
            // An invalid line still takes its number, so that later faces refer to the intended vertices.
            ["v", ..] => {
                if let [_, _, _, _, color @ ..] = words
                    && color.len() >= 3
                {
                    self.color([color[0], color[1], color[2]]);
                }
                push(&mut self.raw.positions, numbers(words).map(DVec3::from_array))
            }
            ["vn", ..] => push(&mut self.raw.normals, numbers(words).map(|n| DVec3::from_array(n).as_vec3())),
            // A texture may have only one coordinate.
            ["vt", _] => push(&mut self.raw.uvs, numbers::<1>(words).map(|[u]| Vec2::new(u as f32, 0.0))),
            ["vt", ..] => push(&mut self.raw.uvs, numbers(words).map(|[u, v]| Vec2::new(u as f32, v as f32))),
            // Old files call a face `fo`.
            ["f" | "fo", corners @ ..] => {
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
                match self.corners.len() {
                    0 | 1 => self.raw.leave_out("points", 1),
                    2 => self.raw.leave_out("lines", 1),
                    _ => self.raw.face(&self.corners),
                }
                Ok(())
            }
            [first, ..] => self.other(first),
            [] => Ok(()),
        }
    }

    /// Sets the color of the current position.
    fn color(&mut self, words: [&str; 3]) {
        let numbers = words.map(str::parse::<f64>);
        let color = numbers.map(|number| number.unwrap_or(f64::NAN));
        self.raw.colors.set_srgb(self.raw.positions.len(), color);
    }

    /// Handles a statement that draws nothing.
    fn other<'a>(&mut self, word: &'a str) -> Result<(), Wrong<'a>> {
        if let Some((_, kind)) = NOT_DRAWN.iter().find(|(keyword, _)| *keyword == word) {
            self.raw.leave_out(kind, 1);
            return Ok(());
        }
        if WITHOUT_EFFECT.split(' ').any(|keyword| keyword == word) {
            return Ok(());
        }
        if word == "call" {
            let help = "insert the lines of the other file here".to_owned();
            return Err((word, "`call` reads another file, which is not supported".to_owned(), help));
        }
        let help = suggest(word, &["v", "vt", "vn", "f", "g", "o", "s", "usemtl", "mtllib"], "statements");
        Err((word, format!("`{word}` is not an OBJ statement"), help))
    }

    /// Parses `position/texture/normal`, the last two optional; indices count from 1, or backward from the last value if negative.
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
                    format!("{what} `{text}` does not exist"),
                    format!("{count} are defined above this line, counted from 1"),
                )),
            }
        };
        let mut parts = word.split('/');
        let mut next = || parts.next().unwrap_or("");
        let position = index(next(), self.raw.positions.len(), "vertex")?;
        let uv = index(next(), self.raw.uvs.len(), "texture coordinate")?;
        let normal = index(next(), self.raw.normals.len(), "normal")?;
        let missing = || (word, "a corner requires a vertex".to_owned(), String::new());
        Ok(Corner::new(position.ok_or_else(missing)?, uv, normal))
    }
}

/// Adds a value, or a default value instead of an invalid one.
fn push<'a, T: Default>(all: &mut Vec<T>, value: Result<T, Wrong<'a>>) -> Result<(), Wrong<'a>> {
    let (value, wrong) = match value {
        Ok(value) => (value, Ok(())),
        Err(wrong) => (T::default(), Err(wrong)),
    };
    all.push(value);
    wrong
}
