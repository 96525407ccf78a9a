//! What programs are linked from: pieces of WGSL, each with a name for errors.

use std::borrow::Cow;
use std::collections::HashSet;

use super::Part;

/// A piece of WGSL: a part, text generated for a scene, or a user's own file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unit {
    /// `law/sources.wgsl`, `generated/shapes.wgsl`, or the path of a user's file as it was given.
    pub file: Cow<'static, str>,
    /// The WGSL.
    pub text: Cow<'static, str>,
    /// Who wrote it.
    pub author: Author,
}

/// Who wrote a piece of WGSL: errors are first of all a user's own to mend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Author {
    /// A file of `shaders/`.
    BuiltIn,
    /// Made for a scene.
    Generated,
    /// A file or a string that a user wrote.
    User,
}

impl Unit {
    /// Text made for a scene.
    #[must_use]
    pub fn generated(file: &'static str, text: String) -> Self {
        Self { file: file.into(), text: text.into(), author: Author::Generated }
    }

    /// A user's own text; errors name `file` as it is given here.
    #[must_use]
    pub fn user(file: impl Into<Cow<'static, str>>, text: impl Into<Cow<'static, str>>) -> Self {
        Self { file: file.into(), text: text.into(), author: Author::User }
    }

    /// Its name in messages, where a reader finds it.
    #[must_use]
    pub fn shown(&self) -> String {
        if self.author == Author::BuiltIn { format!("shaders/{}", self.file) } else { self.file.to_string() }
    }
}

impl From<Part> for Unit {
    fn from(part: Part) -> Self {
        Self { file: part.file.into(), text: part.text.into(), author: Author::BuiltIn }
    }
}

/// What a scene's program is linked from.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Parts {
    /// Parts that all regions share.
    pub shared: Vec<Unit>,
    /// The parts of each kind of region; with more than one kind each gets a copy of its own.
    pub regions: Vec<Vec<Unit>>,
}

/// What parts call where some part declares it, and else not at all: statements on lines of their own.
const OPTIONAL: [&str; 35] = [
    "filter_step",
    "filter_last",
    "filter_left",
    "filter_passed",
    "note_glow",
    "note_pixel",
    "note_arrival",
    "note_sent",
    "note_light",
    "pass_top",
    "leave_aside",
    "load_waiting",
    "store_waiting",
    "draw_wavelength",
    "note_dispersed",
    "color_dispersed",
    "clamp_sample",
    "end_below",
    "keep_end",
    "note_side",
    "pass_throat",
    "note_frequency",
    "note_matter",
    "note_sky",
    "note_end",
    "note_segment",
    "note_passage",
    "add_travel",
    "beam_sky",
    "add_order",
    "see_through",
    "note_footprint",
    "note_place",
    "note_spans",
    "span_pattern",
];

impl Parts {
    /// Without the optional calls of what no part declares.
    #[must_use]
    pub fn without_optional_calls(mut self) -> Self {
        let lines = self.shared.iter().flat_map(|unit| unit.text.lines());
        let declared: HashSet<&str> = lines.filter_map(|line| called(line.strip_prefix("fn ")?)).collect();
        let missing: HashSet<&str> = OPTIONAL.into_iter().filter(|name| !declared.contains(name)).collect();
        let is_missing = |line: &str| called(line.trim_start()).is_some_and(|name| missing.contains(name));
        for unit in self.shared.iter_mut().chain(self.regions.iter_mut().flatten()) {
            if unit.author != Author::User && unit.text.lines().any(is_missing) {
                let kept = unit.text.split_inclusive('\n').filter(|line| !is_missing(line));
                unit.text = kept.collect::<String>().into();
            }
        }
        self
    }
}

/// The name before the first bracket, where a text begins with one.
fn called(text: &str) -> Option<&str> {
    let is_of_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let name = &text[..text.find(|c| !is_of_name(c))?];
    text[name.len()..].starts_with('(').then_some(name)
}
