//! Branches on the features of a scene, replaced by the block that is taken.
//!
//! *Theory.* Features are constants of a program: `const FEATURE: bool = true;`. A module may test one, `if FEATURE { … } else { … }`, so
//! variants that differ in a line do not need separate files. Functions and bindings that only the other block uses are not in the
//! program, because branches are decided before the linker searches for the declarations that a pass reaches.
//!
//! *Practice.* A condition is `FEATURE` or `!FEATURE`. Code after a taken block that returns is dropped too, so a function
//! may begin with `if !FEATURE { return x; }`.

use std::collections::HashMap;
use std::ops::Range;

use super::sources::Known;
use super::tokens::Tokens;

/// Returns the tokens of a unit with every branch on a feature decided.
pub(super) fn folded<'a>(tokens: Tokens<'a>, known: &Known) -> Tokens<'a> {
    let mut fold = Fold { tokens, features: &known.bools, dropped: Vec::new(), raised: Vec::new() };
    fold.block(0..fold.tokens.len());
    fold.left()
}

struct Fold<'a, 'k> {
    tokens: Tokens<'a>,
    features: &'k HashMap<String, bool>,
    dropped: Vec<Range<usize>>,
    /// The tokens whose indentation decreases by one level.
    raised: Vec<Range<usize>>,
}

impl<'a> Fold<'a, '_> {
    /// Decides the branches among these tokens, which are statements or declarations. Returns `true` if the last statement returns.
    fn block(&mut self, tokens: Range<usize>) -> bool {
        let mut i = tokens.start;
        while i < tokens.end {
            match self.tokens.word(i) {
                "return" => return true,
                "{" => {
                    let close = self.closing(i);
                    self.block(i + 1..close);
                    i = close + 1;
                }
                "if" => {
                    let of_else = (self.tokens.before(i) == "else").then(|| i - 1);
                    let Some((next, returns)) = self.branch(i, of_else) else {
                        i += 1;
                        continue;
                    };
                    i = next;
                    if returns && of_else.is_none() {
                        self.drop(i..tokens.end);
                        return true;
                    }
                }
                _ => i += 1,
            }
        }
        false
    }

    /// Decides the branch at this `if`, if its condition is known. Returns the token after it, and whether the remaining code returns.
    /// The branch may follow an `else`.
    fn branch(&mut self, at: usize, of_else: Option<usize>) -> Option<(usize, bool)> {
        let is_not = self.tokens.word(at + 1) == "!";
        let open = at + 2 + usize::from(is_not);
        let value = self.features.get(self.tokens.word(open - 1)).filter(|_| self.tokens.word(open) == "{")?;
        let close = self.closing(open);
        let has_else = self.tokens.word(close + 1) == "else";
        if *value != is_not {
            self.drop(at..open);
            let returns = self.taken(open, of_else.is_some());
            let end = self.end(close);
            self.drop(close + 1..end);
            Some((end, returns))
        } else if !has_else {
            if let Some(i) = of_else {
                self.drop(i..i + 1);
            }
            self.drop(at..close + 1);
            Some((close + 1, false))
        } else {
            let other = close + 2;
            self.drop(at..other);
            if self.tokens.word(other) == "{" {
                return Some((self.closing(other) + 1, self.taken(other, of_else.is_some())));
            }
            self.branch(other, of_else).or(Some((other + 1, false)))
        }
    }

    /// Keeps a block, without its braces if they are not needed. Returns `true` if the block returns.
    fn taken(&mut self, open: usize, is_else: bool) -> bool {
        let close = self.closing(open);
        let mut depth = 0;
        let declares = (open + 1..close).any(|i| {
            match self.tokens.word(i) {
                "{" => depth += 1,
                "}" => depth -= 1,
                _ => {}
            }
            depth == 0 && matches!(self.tokens.word(i), "let" | "var" | "const")
        });
        let has_braces = is_else || declares;
        if !has_braces {
            self.drop(open..open + 1);
            self.raised.push(open + 1..close);
        }
        let returns = self.block(open + 1..close);
        if !has_braces {
            self.drop(close..close + 1);
        }
        returns
    }

    /// Returns the token after the `else` branches of the block that closes at `close`.
    fn end(&self, close: usize) -> usize {
        if self.tokens.word(close + 1) != "else" {
            return close + 1;
        }
        let open = (close + 2..self.tokens.len()).find(|&i| self.tokens.word(i) == "{");
        open.map_or(self.tokens.len(), |open| self.end(self.closing(open)))
    }

    /// Returns the brace that closes `open`, or the last token if there is none, which the linker reports.
    fn closing(&self, open: usize) -> usize {
        self.tokens.closing(open).unwrap_or(self.tokens.len() - 1)
    }

    fn drop(&mut self, tokens: Range<usize>) {
        if !tokens.is_empty() {
            self.dropped.push(tokens);
        }
    }

    /// Returns the remaining tokens. A comment above a block that remains stays above it.
    fn left(mut self) -> Tokens<'a> {
        for range in &self.raised {
            for token in self.tokens.0[range.clone()].iter_mut().filter(|token| token.gap.contains('\n')) {
                token.gap = token.gap.replace("\n    ", "\n").into();
            }
        }
        let mut kept = vec![true; self.tokens.len()];
        for range in &self.dropped {
            kept[range.clone()].fill(false);
        }
        for Range { start, end } in &self.dropped {
            let is_block = self.tokens.word(*start) == "if" && self.tokens.word(end.saturating_sub(1)) != "}";
            let Some(next) = (*end..self.tokens.len()).find(|&i| kept[i]).filter(|_| is_block) else { continue };
            if self.tokens.0[*start].gap.contains("//") {
                let above = self.tokens.0[*start].gap.trim_end().to_owned();
                let below = &mut self.tokens.0[next].gap;
                *below = (above + below).into();
            }
        }
        let mut kept = kept.into_iter();
        self.tokens.0.retain(|_| kept.next().unwrap_or(true));
        self.tokens
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::sources::Sources;
    use crate::program::{Parts, Unit};

    fn folded_text(text: &str) -> String {
        let features = "const YES: bool = true;\nconst NO: bool = false;\n".to_owned();
        let shared = vec![Unit::generated("features.wgsl", features), Unit::generated("a.wgsl", text.to_owned())];
        all_folded(&Parts { shared, ..Parts::default() }).remove(1)
    }

    fn all_folded(parts: &Parts) -> Vec<String> {
        Sources::edited(parts, |sources| sources.edit(folded))
    }

    fn flat(text: &str) -> String {
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn the_block_that_is_taken_stays() {
        for (text, left) in [
            ("fn f() { if YES { a(); } b(); }", "fn f() { a(); b(); }"),
            ("fn f() { if NO { a(); } b(); }", "fn f() { b(); }"),
            ("fn f() { if !NO { a(); } else { b(); } c(); }", "fn f() { a(); c(); }"),
            ("fn f() { if !YES { a(); } else { b(); } c(); }", "fn f() { b(); c(); }"),
            ("fn f() { if YES { let x = 1; a(x); } c(); }", "fn f() { { let x = 1; a(x); } c(); }"),
            ("fn f() { if YES { if x { let y = 1; } } c(); }", "fn f() { if x { let y = 1; } c(); }"),
            ("fn f() { for (;;) { if NO { a(); } if !NO { b(); } } }", "fn f() { for (;;) { b(); } }"),
        ] {
            assert_eq!(flat(&folded_text(text)), left, "{text}");
        }
    }

    #[test]
    fn chains_are_decided_link_by_link() {
        for (text, left) in [
            ("if NO { a(); } else if x { b(); } else { c(); }", "if x { b(); } else { c(); }"),
            ("if NO { a(); } else if YES { b(); } else { c(); }", "b();"),
            ("if YES { a(); } else if x { b(); } else { c(); }", "a();"),
            ("if x { a(); } else if YES { b(); } else { c(); }", "if x { a(); } else { b(); }"),
            ("if x { a(); } else if NO { b(); } else { c(); }", "if x { a(); } else { c(); }"),
            ("if x { a(); } else if NO { b(); } c();", "if x { a(); } c();"),
            ("if x { a(); } else if NO { b(); } else if NO { c(); } d();", "if x { a(); } d();"),
        ] {
            assert_eq!(flat(&folded_text(&format!("fn f() {{ {text} }}"))), format!("fn f() {{ {left} }}"), "{text}");
        }
    }

    #[test]
    fn nothing_follows_a_return() {
        for (text, left) in [
            ("if YES { return 1; } let x = 2; return x;", "return 1;"),
            ("if NO { return 1; } let x = 2; return x;", "let x = 2; return x;"),
            ("if YES { if YES { return 1; } b(); } return 2;", "return 1;"),
            ("if x { if YES { return 1; } b(); } return 2;", "if x { return 1; } return 2;"),
            ("if x { a(); } else if YES { return 1; } return 2;", "if x { a(); } else { return 1; } return 2;"),
        ] {
            assert_eq!(flat(&folded_text(&format!("fn f() {{ {text} }}"))), format!("fn f() {{ {left} }}"), "{text}");
        }
    }

    #[test]
    fn other_conditions_and_users_files_stay() {
        let texts =
            ["if YES && x { a(); }", "if x == YES { a(); }", "if a.YES { a(); }", "if OTHER { a(); }", "let x = YES;"];
        for text in texts.map(|text| format!("fn f() {{ {text} }}")) {
            assert_eq!(folded_text(&text), text);
        }
        let own = "const MINE: bool = true;\nfn f() { if MINE { a(); } if YES { b(); } }";
        let shared =
            vec![Unit::user("a.wgsl", own), Unit::generated("b.wgsl", "fn g() { if MINE { a(); } }".to_owned())];
        let left = all_folded(&Parts { shared, ..Parts::default() });
        assert_eq!(left, [own, "fn g() { if MINE { a(); } }"]);
    }

    #[test]
    fn a_region_has_features_of_its_own() {
        let unit = |text: &str| Unit::generated("a.wgsl", text.to_owned());
        let region =
            |value: bool| vec![unit(&format!("const LEAPS: bool = {value};")), unit("fn f() { if LEAPS { a(); } }")];
        let left = all_folded(&Parts {
            shared: vec![unit("fn g() {}")],
            regions: vec![region(true), region(false)],
            ..Parts::default()
        });
        assert_eq!([2, 4].map(|k| flat(&left[k])), ["fn f() { a(); }", "fn f() { }"]);
    }

    #[test]
    fn what_stays_is_laid_out_as_if_it_stood_alone() {
        for (text, left) in [
            (
                "fn f() {\n    if NO {\n        a();\n    }\n    // why\n    if YES {\n        // more\n        b(\n            1,\n        );\n    } else {\n        c();\n    }\n\n    d();\n}",
                "fn f() {\n    // why\n    // more\n    b(\n        1,\n    );\n\n    d();\n}",
            ),
            ("fn f() {\n    // why\n    if NO {\n        a();\n    }\n    b();\n}", "fn f() {\n    b();\n}"),
        ] {
            assert_eq!(folded_text(text), left);
        }
    }
}
