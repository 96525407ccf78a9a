//! Loops whose count is known, written out (W04 §7 unrolls its own).
//!
//! *Theory.* Every loop costs a pass a counter, naga's bound on the number of its turns, and on a processor a mask of the lanes that
//! are still in it; and a uniform read at a place that changes is read once for every lane. A loop of a few turns over a list whose
//! length the linker knows needs none of that.
//!
//! *Practice.* `for (var i = 0u; i < COUNT; i++) { … }`, where COUNT is a number or a constant of the program, becomes its body once
//! for each i, unless the body leaves the loop itself or the whole would be long. The first copy keeps the lines of the text, so that
//! places in files stay what they are. Users' own files are left as they were written.

use std::borrow::Cow;
use std::collections::HashMap;
use std::fmt::Write as _;
use std::ops::Range;

use super::tokens::{Tokens, whole_number};
use super::unit::{Author, Parts, Unit};

/// Tokens that a loop may come to.
const LONGEST: usize = 400;

/// The parts with their short loops written out.
pub(super) fn unrolled(parts: &Parts) -> Parts {
    parts.edited(constants, unrolled_unit)
}

/// Whole numbers that units give a name.
pub(super) fn constants(units: &[Unit]) -> HashMap<String, u32> {
    let mut named = HashMap::new();
    for unit in units.iter().filter(|unit| unit.text.contains("const")) {
        let tokens = Tokens::of(&unit.text);
        for i in (0..tokens.len()).filter(|&i| tokens.word(i) == "const") {
            let is_whole = tokens.word(i + 2) == ":" && tokens.word(i + 4) == "=" && tokens.word(i + 6) == ";";
            if let (true, Some(number)) = (is_whole, whole_number(tokens.word(i + 5))) {
                named.insert(tokens.word(i + 1).to_owned(), number);
            }
        }
    }
    named
}

fn unrolled_unit(unit: &Unit, constants: &HashMap<String, u32>) -> Unit {
    if unit.author == Author::User || !unit.text.contains("for") {
        return unit.clone();
    }
    let mut text = unit.text.clone();
    // The innermost first: what contains them is found again, longer.
    while let Some((range, written)) = first_loop(&text, constants) {
        text = Cow::Owned([&text[..range.start], &written, &text[range.end..]].concat());
    }
    Unit { text, ..unit.clone() }
}

/// A loop that can be written out, and what it is then.
fn first_loop(text: &str, constants: &HashMap<String, u32>) -> Option<(Range<usize>, String)> {
    let tokens = Tokens::of(text);
    (0..tokens.len()).rev().filter(|&i| tokens.word(i) == "for").find_map(|at| {
        let counted = Counted::at(&tokens, at, constants)?;
        let end = tokens.range(counted.body.end).end;
        Some((tokens.range(at).start..end, counted.written(&tokens)))
    })
}

/// A loop over whole numbers.
struct Counted<'a> {
    name: &'a str,
    turns: Range<u32>,
    /// Behind a number of the counter's type.
    suffix: &'static str,
    /// The tokens between its braces.
    body: Range<usize>,
}

impl<'a> Counted<'a> {
    /// `for ( var i = FROM ; i < TO ; i ++ ) {`
    fn at(tokens: &Tokens<'a>, at: usize, constants: &HashMap<String, u32>) -> Option<Self> {
        let word = |k: usize| tokens.word(at + k);
        let number = |word: &str| whole_number(word).or_else(|| constants.get(word).copied());
        let name = word(3);
        let signs = [(1, "("), (2, "var"), (4, "="), (6, ";"), (7, name), (8, "<"), (10, ";"), (11, name)];
        let ends = [(12, "+"), (13, "+"), (14, ")"), (15, "{")];
        let is_counted = signs.into_iter().chain(ends).all(|(k, sign)| word(k) == sign);
        let turns = number(word(5)).filter(|_| is_counted)?..number(word(9))?;
        let body = at + 16..tokens.closing(at + 15)?;
        let leaves = body.clone().any(|i| matches!(tokens.word(i), "break" | "continue"));
        let is_short = turns.len() * body.len() <= LONGEST;
        let suffix = if word(9).ends_with('i') || whole_number(word(5)).is_some() && !word(5).ends_with('u') {
            "i"
        } else {
            "u"
        };
        (!leaves && is_short).then_some(Self { name, turns, suffix, body })
    }

    /// The body for each number: for the first with its lines, for the others in one.
    fn written(&self, tokens: &Tokens) -> String {
        let opened = tokens.range(self.body.start - 1).end;
        let body = &self.body;
        let mut text = String::new();
        for turn in self.turns.clone() {
            text += "{ ";
            let mut done = opened;
            for i in body.clone() {
                let range = tokens.range(i);
                let between = &tokens.text[done..range.start];
                if turn == self.turns.start {
                    text += between;
                } else if !between.is_empty() {
                    text.push(' ');
                }
                // Writing to a String cannot fail.
                let _ = match tokens.word(i) {
                    word if word == self.name && tokens.before(i) != "." => write!(text, "{turn}{}", self.suffix),
                    word => write!(text, "{word}"),
                };
                done = range.end;
            }
            if turn == self.turns.start {
                text += &tokens.text[done..tokens.range(self.body.end).start];
            }
            text += "} ";
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(text: &'static str) -> String {
        let parts = Parts { shared: vec![Unit::generated("a.wgsl", text.to_owned())], ..Parts::default() };
        unrolled(&parts).shared[0].text.to_string()
    }

    #[test]
    fn a_short_loop_is_its_body_for_each_number() {
        let text = "const N: u32 = 2u;\nfn f() {\n    for (var i = 0u; i < N; i++) {\n        g(i); // turns\n        \
                    a[i] += p.i;\n    }\n    for (var k = 1; k < 3; k++) { b(k); }\n}\n";
        let out = written(text);
        let flat = out.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            flat.contains("{ g(0u); // turns a[0u] += p.i; } { g(1u); a[1u] += p.i;} { b(1i); } { b(2i);}"),
            "{out}"
        );
        assert_eq!(out.matches('\n').count(), text.matches('\n').count(), "lines stay where they are");
    }

    #[test]
    fn loops_in_loops_are_written_out_from_within() {
        let out = written("fn f() { for (var i = 0u; i < 2u; i++) { for (var k = 0u; k < 2u; k++) { g(i, k); } } }");
        for call in ["g(0u, 0u)", "g(0u, 1u)", "g(1u, 0u)", "g(1u, 1u)"] {
            assert_eq!(out.matches(call).count(), 1, "{call}: {out}");
        }
        assert!(!out.contains("for"), "{out}");
    }

    #[test]
    fn what_is_long_or_left_or_open_or_a_users_stays() {
        for text in [
            "fn f() { for (var i = 0u; i < 1000u; i++) { g(i); } }",
            "fn f() { for (var i = 0u; i < 2u; i++) { if g(i) { break; } } }",
            "fn f(n: u32) { for (var i = 0u; i < n; i++) { g(i); } }",
            "fn f() { for (var i = 0u; i < 2u && g(i); i++) { h(i); } }",
        ] {
            assert_eq!(written(text), text);
        }
        let own = "fn f() { for (var i = 0u; i < 2u; i++) { g(i); } }";
        let parts = Parts { shared: vec![Unit::user("a.wgsl", own)], ..Parts::default() };
        assert_eq!(unrolled(&parts).shared[0].text, own);
    }
}
