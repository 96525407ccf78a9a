//! Unrolling of loops with a known count (W04 §7 unrolls its loops).
//!
//! *Theory.* Every loop costs a pass a counter, naga's limit on the number of iterations, and on a CPU a mask of the active lanes.
//! In addition, a uniform read at a varying index is read once for every lane. A loop with few iterations over a list
//! with a length known to the linker needs none of that.
//!
//! *Practice.* `for (var i = 0u; i < COUNT; i++) { … }`, where COUNT is a number or a constant of the program, becomes its body once
//! for each i, unless the body leaves the loop itself or the result would be long.

use std::ops::Range;

use super::sources::Known;
use super::tokens::{Token, Tokens, whole_number};

/// The largest number of tokens of an unrolled loop.
const LONGEST: usize = 400;

/// Returns the tokens of a unit with its short loops unrolled.
pub(super) fn unrolled<'a>(mut tokens: Tokens<'a>, known: &Known) -> Tokens<'a> {
    // The innermost loop comes first; the loop around it is found again, longer.
    while let Some((at, counted)) = next_loop(&tokens, known) {
        let written = counted.written(&tokens, at);
        tokens = tokens.spliced(vec![(at..counted.body.end + 1, written)]);
    }
    tokens
}

/// Returns the last loop that can be unrolled, with its token.
fn next_loop(tokens: &Tokens, known: &Known) -> Option<(usize, Counted)> {
    let mut loops = (0..tokens.len()).rev().filter(|&i| tokens.word(i) == "for");
    loops.find_map(|at| Some((at, Counted::at(tokens, at, known)?)))
}

/// A loop over whole numbers.
struct Counted {
    name: String,
    turns: Range<u32>,
    /// The suffix of a number of the counter's type.
    suffix: &'static str,
    /// The tokens between its braces.
    body: Range<usize>,
}

impl Counted {
    /// Reads a loop `for ( var i = FROM ; i < TO ; i ++ ) {`.
    fn at(tokens: &Tokens, at: usize, known: &Known) -> Option<Self> {
        let word = |k: usize| tokens.word(at + k);
        let name = word(3);
        let signs = [(1, "("), (2, "var"), (4, "="), (6, ";"), (7, name), (8, "<"), (10, ";"), (11, name)];
        let ends = [(12, "+"), (13, "+"), (14, ")"), (15, "{")];
        let is_counted = tokens.are(at, &signs) && tokens.are(at, &ends);
        let turns = known.number(word(5)).filter(|_| is_counted)?..known.number(word(9))?;
        let body = at + 16..tokens.closing(at + 15)?;
        let leaves = body.clone().any(|i| matches!(tokens.word(i), "break" | "continue"));
        let is_short = turns.len() * body.len() <= LONGEST;
        let suffix = if word(9).ends_with('i') || whole_number(word(5)).is_some() && !word(5).ends_with('u') {
            "i"
        } else {
            "u"
        };
        (!leaves && is_short).then(|| Self { name: name.to_owned(), turns, suffix, body })
    }

    /// Returns the body for each number: with its line breaks for the first number, and on one line for the others.
    fn written<'a>(&self, tokens: &Tokens<'a>, at: usize) -> Vec<Token<'a>> {
        let mut written = Vec::new();
        for turn in self.turns.clone() {
            let is_first = turn == self.turns.start;
            let gap = if is_first { tokens.0[at].gap.clone() } else { " ".into() };
            written.push(Token { gap, ..tokens.0[self.body.start - 1].clone() });
            for i in self.body.start..=self.body.end {
                let mut token = tokens.0[i].clone();
                if token.word == *self.name && tokens.before(i) != "." {
                    token.word = format!("{turn}{}", self.suffix).into();
                }
                if !is_first && !token.gap.is_empty() {
                    token.gap = " ".into();
                }
                written.push(token);
            }
        }
        written
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::sources::Sources;
    use crate::program::{Parts, Unit};

    fn written(text: &'static str) -> String {
        let parts = Parts { shared: vec![Unit::generated("a.wgsl", text.to_owned())], ..Parts::default() };
        Sources::edited(&parts, |sources| sources.edit(unrolled)).remove(0)
    }

    #[test]
    fn a_short_loop_is_its_body_for_each_number() {
        let text = "const N: u32 = 2u;\nfn f() {\n    for (var i = 0u; i < N; i++) {\n        g(i); // turns\n        \
                    a[i] += p.i;\n    }\n    for (var k = 1; k < 3; k++) { b(k); }\n}\n";
        let out = written(text);
        let flat = out.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            flat.contains("{ g(0u); // turns a[0u] += p.i; } { g(1u); a[1u] += p.i; } { b(1i); } { b(2i); }"),
            "{out}"
        );
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
        assert_eq!(Sources::edited(&parts, |sources| sources.edit(unrolled)), [own]);
    }
}
