//! What programs are linked from: pieces of WGSL, each with a name for errors.

use std::borrow::Cow;
use std::collections::HashSet;
use std::ops::Range;

use super::Part;
use super::tokens::Tokens;

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

/// Functions that parts call only if some part declares them. Each such call is a statement.
const OPTIONAL: [&str; 36] = [
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
    "note_corners",
    "note_spans",
    "span_pattern",
];

impl Parts {
    /// Removes the calls of optional functions that no part declares.
    #[must_use]
    pub fn without_optional_calls(mut self) -> Self {
        let units = self.shared.iter().chain(self.regions.iter().flatten());
        let declared: HashSet<&str> = units.flat_map(|unit| functions(&Tokens::of(&unit.text))).collect();
        let missing: HashSet<&str> = OPTIONAL.into_iter().filter(|name| !declared.contains(name)).collect();
        for unit in self.shared.iter_mut().chain(self.regions.iter_mut().flatten()) {
            if unit.author != Author::User
                && let Some(text) = without_calls(&unit.text, &missing)
            {
                unit.text = text.into();
            }
        }
        self
    }
}

/// The functions that a text declares.
fn functions<'a>(tokens: &Tokens<'a>) -> Vec<&'a str> {
    (1..tokens.len()).filter(|&i| tokens.before(i) == "fn").map(|i| tokens.word(i)).collect()
}

/// Returns `text` without the statements that call a function of these names, or `None` if there are none.
fn without_calls(text: &str, names: &HashSet<&str>) -> Option<String> {
    let tokens = Tokens::of(text);
    let mut left = String::new();
    let mut from = 0;
    for call in (0..tokens.len()).filter(|&i| names.contains(tokens.word(i))) {
        if let Some(statement) = call_statement(&tokens, call) {
            let removed = with_blank_line(text, statement);
            left += &text[from..removed.start];
            from = removed.end;
        }
    }
    (from > 0).then(|| left + &text[from..])
}

/// Where the statement stands that is nothing but a call of the function named by the token `call`.
fn call_statement(tokens: &Tokens, call: usize) -> Option<Range<usize>> {
    let is_call = matches!(tokens.before(call), "{" | "}" | ";") && tokens.word(call + 1) == "(";
    let end = if is_call { tokens.closing(call + 1)? + 1 } else { return None };
    (tokens.word(end) == ";").then(|| tokens.range(call).start..tokens.range(end).end)
}

/// The range together with its line's spaces and end, where nothing else stands on its lines.
fn with_blank_line(text: &str, range: Range<usize>) -> Range<usize> {
    let is_space = |c: char| c == ' ' || c == '\t';
    let before = text[..range.start].trim_end_matches(is_space);
    let behind = text[range.end..].trim_start_matches(is_space);
    match behind.strip_prefix('\n') {
        Some(next) if before.is_empty() || before.ends_with('\n') => before.len()..text.len() - next.len(),
        _ => range,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::all_parts;

    fn without(text: &str) -> Option<String> {
        without_calls(text, &HashSet::from(["note_end", "note_sky"]))
    }

    #[test]
    fn calls_are_removed_as_statements() {
        for (text, left) in [
            ("fn f() {\n    note_end(p);\n    g();\n}\n", "fn f() {\n    g();\n}\n"),
            (
                "fn f() {\n    note_end(\n        at(p, q[1]),\n        v, // );\n    );\n    g();\n}\n",
                "fn f() {\n    g();\n}\n",
            ),
            ("fn f() { if a < b { note_end(max(a, (b)), vec2<f32>(c)); } }", "fn f() { if a < b {  } }"),
            ("fn f() {\n    note_end(p); note_sky /* twice */ (q)\n    ;\n}\n", "fn f() {\n     \n}\n"),
            ("fn f() {\n    note_end(p); // why\n}\n", "fn f() {\n     // why\n}\n"),
        ] {
            assert_eq!(without(text).as_deref(), Some(left), "{text}");
        }
    }

    /// These name the function for something else, or for a value that cannot be left out: the program then does not link.
    #[test]
    fn other_uses_stay() {
        for text in [
            "fn f() { let a = note_end(p); }",
            "fn f() { a.note_end(p); }",
            "fn f() { note_ends(p); } // note_end(p);",
            "fn f() { g(note_end(p)); }",
            "fn note_end(p: f32) { g(p); }",
        ] {
            assert_eq!(without(text), None, "{text}");
        }
    }

    #[test]
    fn users_text_is_left_as_it_is() {
        let text = "fn f() {\n    note_end(1.0);\n}\n";
        let unit = |author| Unit { file: "a.wgsl".into(), text: text.into(), author };
        let of = |shared| Parts { shared, regions: Vec::new() }.without_optional_calls().shared;
        assert_eq!(of(vec![unit(Author::User)])[0].text, text);
        assert_eq!(of(vec![unit(Author::BuiltIn)])[0].text, "fn f() {\n}\n");
        let declared =
            of(vec![unit(Author::BuiltIn), Unit::generated("b.wgsl", "fn\nnote_end (p: f32) {}".to_owned())]);
        assert_eq!(declared[0].text, text);
    }

    /// A name that is misspelled where it is declared, where it is called or in the table would remove calls without a word.
    #[test]
    fn every_optional_function_is_declared_and_called_by_parts() {
        let parts = all_parts();
        let all: Vec<Tokens> = parts.iter().map(|part| Tokens::of(part.text)).collect();
        let is_called = |name: &str| {
            let calls = |tokens: &Tokens| {
                (0..tokens.len()).any(|i| tokens.word(i) == name && call_statement(tokens, i).is_some())
            };
            all.iter().any(calls)
        };
        let contracts = include_str!("../../shaders/README.md");
        for name in OPTIONAL {
            assert!(contracts.contains(&format!("`fn {name}(")), "shaders/README.md does not state `{name}`");
            assert!(all.iter().any(|tokens| functions(tokens).contains(&name)), "no part declares `{name}`");
            assert!(is_called(name), "no part calls `{name}`");
        }
    }
}
