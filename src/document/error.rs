//! The errors of a scene, each with its location in the file and a suggested fix.

use std::borrow::Cow;
use std::fmt;
use std::path::{Path, PathBuf};

/// The largest number of mistakes that one run collects.
pub(super) const ENOUGH: usize = 1000;
/// The largest number of mistakes that a message prints.
const SHOWN: usize = 100;
/// The largest number of characters of a line that a message prints.
const WIDTH: usize = 160;
/// The largest length of a message, in bytes; a message may quote a word of the file, which may have any length.
const LONGEST: usize = 2000;

/// The reason why a scene could not be loaded.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// A file that cannot be read.
    #[error("cannot read `{}`: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The error of the operating system.
        source: std::io::Error,
    },
    /// An image that can be read but not decoded or not used.
    #[error("cannot use the image `{}`: {}", path.display(), brief(problem))]
    Picture {
        /// The file.
        path: PathBuf,
        /// The problem.
        problem: String,
    },
    /// A mesh in a format without lines that can be read but not decoded or not used.
    #[error("cannot use the mesh `{}`: {}", path.display(), brief(problem))]
    Mesh {
        /// The file.
        path: PathBuf,
        /// The problem.
        problem: String,
    },
    /// A file of samples that can be read but not used.
    #[error("cannot use the grid `{}`: {}", path.display(), brief(problem))]
    Grid {
        /// The file.
        path: PathBuf,
        /// The problem.
        problem: String,
    },
    /// A file that needs more memory than is allowed.
    #[error("cannot load `{}`: it needs {} of memory, and {} of {} are left", path.display(), mebibytes(*needed), mebibytes(*left), mebibytes(*limit))]
    Memory {
        /// The file.
        path: PathBuf,
        /// The least number of bytes that the file needs.
        needed: u64,
        /// The bytes that the files before it have left.
        left: u64,
        /// The bytes that all files together may use.
        limit: u64,
    },
    /// A `--set` argument that is not `KEY=VALUE`.
    #[error("{}", brief(.0))]
    Override(String),
    /// All errors of the scene and its meshes, in the order of the file.
    #[error("{}", list(.0))]
    Diagnostics(Vec<Diagnostic>),
}

/// Formats a number of bytes in MiB.
fn mebibytes(bytes: u64) -> String {
    format!("{:.1} MiB", bytes as f64 / f64::from(1 << 20))
}

/// One error at one location of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// The scene, a mesh that it names, or `--set KEY=VALUE` as it was given.
    pub file: PathBuf,
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1, in characters.
    pub column: usize,
    /// The offending text from the column on; empty if something is missing.
    pub excerpt: String,
    /// The whole line of the error.
    pub context: String,
    /// The problem.
    pub problem: String,
    /// The remedy; empty if the problem already states it.
    pub help: String,
}

impl Diagnostic {
    /// Locates a mistake in bytes `start..end` of `text`; a span of several lines is cut at the end of its first line.
    #[must_use]
    pub fn locate(file: PathBuf, text: &str, start: usize, end: usize, problem: String, help: String) -> Self {
        let start = char_boundary(text, start);
        let line_start = text[..start].rfind('\n').map_or(0, |i| i + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |i| start + i);
        let end = char_boundary(text, end).clamp(start, line_end);
        Self {
            file,
            line: text[..line_start].matches('\n').count() + 1,
            column: text[line_start..start].chars().count() + 1,
            excerpt: text[start..end].trim_end().to_owned(),
            context: text[line_start..line_end].trim_end().to_owned(),
            problem,
            help,
        }
    }

    /// Locates a mistake in `part`, which must be a slice of `text`.
    #[must_use]
    pub fn of(file: &Path, text: &str, part: &str, problem: String, help: String) -> Self {
        // A slice's offset is the distance between the two addresses.
        let start = part.as_ptr() as usize - text.as_ptr() as usize;
        Self::locate(file.to_owned(), text, start, start + part.len(), problem, help)
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (file, line, column) = (self.file.display(), self.line, self.column);
        write!(f, "{file}:{line}:{column}: {}", brief(&self.problem))?;
        let shown = self.context.trim_start();
        if !shown.is_empty() {
            let indent = self.context.chars().count() - shown.chars().count();
            // A very long line is cut to the part around the mistake.
            let skipped = (column - 1).saturating_sub(indent).saturating_sub(WIDTH / 2);
            let (skipped, dots) = if skipped > 3 { (skipped, "…") } else { (0, "") };
            let pad = " ".repeat((column - 1).saturating_sub(indent + skipped) + dots.chars().count());
            let carets = "^".repeat(self.excerpt.chars().count().clamp(1, WIDTH / 2));
            let rest: String = shown.chars().skip(skipped).take(WIDTH).collect();
            let more = if shown.chars().nth(skipped + WIDTH).is_some() { "…" } else { "" };
            write!(f, "\n    {dots}{}{more}\n    {pad}{carets}", visible(&rest.replace('\t', " ")))?;
        }
        if !self.help.is_empty() {
            write!(f, "\n    help: {}", brief(&self.help))?;
        }
        Ok(())
    }
}

/// Returns a message that may quote a file, ready to print: with visible
/// characters, see [`visible`], and without its middle if it is too long.
pub fn brief(text: &str) -> Cow<'_, str> {
    if text.len() <= LONGEST {
        return visible(text);
    }
    let (start, end) = (char_boundary(text, LONGEST / 2), char_boundary(text, text.len() - LONGEST / 2));
    Cow::Owned(format!("{} … {}", visible(&text[..start]), visible(&text[end..])))
}

/// Returns a text with a visible character for each character that would control
/// the terminal, reorder the line or be invisible. Columns do not change.
fn visible(text: &str) -> Cow<'_, str> {
    /// The first of Unicode's symbols for control characters, which are in the order of their codes.
    const PICTURES: u32 = 0x2400;
    let is_hidden = |sign: char| match sign {
        '\n' => false,
        '\u{200B}' | '\u{200E}' | '\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2060}'..='\u{2069}' | '\u{FEFF}' => true,
        _ => sign.is_control(),
    };
    if !text.contains(is_hidden) {
        return Cow::Borrowed(text);
    }
    let picture = |sign: char| match sign {
        '\0'..=' ' => char::from_u32(PICTURES + u32::from(sign)).unwrap_or(char::REPLACEMENT_CHARACTER),
        '\x7F' => '\u{2421}',
        _ => char::REPLACEMENT_CHARACTER,
    };
    Cow::Owned(text.chars().map(|sign| if is_hidden(sign) { picture(sign) } else { sign }).collect())
}

/// Returns the last character boundary that is not after byte `at`.
fn char_boundary(text: &str, at: usize) -> usize {
    let boundary = |&i: &usize| text.is_char_boundary(i);
    (0..=at.min(text.len())).rfind(boundary).unwrap_or(0)
}

fn list(mistakes: &[Diagnostic]) -> String {
    let mut parts: Vec<String> = mistakes.iter().take(SHOWN).map(Diagnostic::to_string).collect();
    let plural = if mistakes.len() == 1 { "" } else { "s" };
    let least = if mistakes.len() >= ENOUGH { "at least " } else { "" };
    let shown = if mistakes.len() > SHOWN { format!(", of which {SHOWN} are shown") } else { String::new() };
    parts.push(format!("{least}{} error{plural}{shown}", mistakes.len()));
    parts.join("\n\n")
}
