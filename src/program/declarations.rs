//! WGSL text as its top-level declarations: just enough reading to link by name.
//!
//! WGSL at module scope has no order and no scopes but one, so that a declaration is known by its name, and what it needs
//! by the identifiers in it. Nothing is parsed further: that is naga's work, on the linked program.

use std::ops::Range;

/// One function, struct, alias, constant or variable of a part.
#[derive(Debug, Clone)]
pub struct Declaration<'a> {
    /// What it declares.
    pub name: &'a str,
    /// `fn`, `struct`, `alias`, `const` or `var`.
    pub keyword: &'a str,
    /// Its text, with the comment above it.
    pub text: &'a str,
    /// The line of the part that its text starts on, from 1.
    pub line: usize,
    /// Where identifiers stand in `text`, but for those behind a dot, which name members.
    pub identifiers: Vec<Range<usize>>,
}

impl Declaration<'_> {
    /// The identifiers themselves.
    pub fn used(&self) -> impl Iterator<Item = &str> {
        self.identifiers.iter().map(|range| &self.text[range.clone()])
    }
}

/// The declarations of `source`, in order. A comment with an empty line below it belongs to none.
#[must_use]
pub fn declarations(source: &str) -> Vec<Declaration<'_>> {
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(end) = declaration_end(source, from) {
        let start = with_own_comment(source, from, end);
        let text = &source[start..end];
        let identifiers = identifiers(text);
        if let Some((keyword, name)) = keyword_and_name(text, &identifiers) {
            let line = 1 + source[..start].matches('\n').count();
            found.push(Declaration { name, keyword, text, line, identifiers });
        }
        from = end;
    }
    found
}

/// Just behind the `;` or the outermost `}` that closes the declaration which starts at or after `from`.
fn declaration_end(source: &str, from: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for token in Tokens::new(source, from) {
        match &source[token.clone()] {
            "{" => depth += 1,
            "}" => {
                depth = depth.saturating_sub(1);
                if depth == 0 {
                    return Some(token.end);
                }
            }
            ";" if depth == 0 => return Some(token.end),
            _ => {}
        }
    }
    None
}

/// The start of the declaration's first token, or of the comment that stands directly above it.
fn with_own_comment(source: &str, from: usize, end: usize) -> usize {
    let first = Tokens::new(source, from).next().map_or(from, |token| token.start);
    let gap = &source[from..first.min(end)];
    gap.rfind("\n\n").map_or_else(|| from + gap.len() - gap.trim_start().len(), |blank| from + blank + 2)
}

const KEYWORDS: [&str; 6] = ["fn", "struct", "alias", "const", "var", "override"];

fn keyword_and_name<'a>(text: &'a str, identifiers: &[Range<usize>]) -> Option<(&'a str, &'a str)> {
    let mut words = identifiers.iter();
    let keyword = words.find_map(|range| {
        let word = &text[range.clone()];
        KEYWORDS.contains(&word).then_some(word)
    })?;
    let address_space = ["uniform", "storage", "private", "workgroup", "read", "read_write"];
    let name =
        words.map(|range| &text[range.clone()]).find(|word| !(keyword == "var" && address_space.contains(word)))?;
    Some((keyword, name))
}

/// Names that stand for something of module scope: no members, and nothing that the declaration names itself (members of a
/// struct, parameters, local variables), for that hides what has the same name outside.
fn identifiers(text: &str) -> Vec<Range<usize>> {
    let tokens: Vec<Range<usize>> = Tokens::new(text, 0).collect();
    let word = |i: Option<usize>| i.and_then(|i| tokens.get(i)).map_or("", |token| &text[token.clone()]);
    let is_name = |i: usize| word(Some(i)).starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    let names = (0..tokens.len()).filter(|&i| is_name(i) && word(i.checked_sub(1)) != ".");
    let keyword = (0..tokens.len()).map(|i| word(Some(i))).find(|word| KEYWORDS.contains(word));
    let has_inside = matches!(keyword, Some("fn" | "struct"));
    let own: Vec<&str> = names
        .clone()
        .filter(|&i| {
            // `case NAME: {` and `default: {` name nothing.
            let typed = word(Some(i + 1)) == ":" && word(Some(i + 2)) != "{";
            has_inside && (typed || matches!(word(i.checked_sub(1)), "let" | "var" | "const"))
        })
        .map(|i| word(Some(i)))
        .collect();
    names.filter(|&i| !own.contains(&word(Some(i)))).map(|i| tokens[i].clone()).collect()
}

/// Words, numbers and single signs; comments and spaces are passed over.
struct Tokens<'a> {
    source: &'a str,
    at: usize,
}

impl<'a> Tokens<'a> {
    fn new(source: &'a str, at: usize) -> Self {
        Self { source, at }
    }
}

impl Iterator for Tokens<'_> {
    type Item = Range<usize>;

    fn next(&mut self) -> Option<Range<usize>> {
        loop {
            let rest = &self.source[self.at..];
            self.at += rest.len() - rest.trim_start().len();
            let rest = rest.trim_start();
            if rest.starts_with("//") {
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else if rest.starts_with("/*") {
                self.at += rest.find("*/").map_or(rest.len(), |end| end + 2);
            } else {
                let first = rest.chars().next()?;
                let word = |c: char| c.is_ascii_alphanumeric() || c == '_';
                let length = if word(first) { rest.find(|c| !word(c)).unwrap_or(rest.len()) } else { first.len_utf8() };
                self.at += length;
                return Some(self.at - length..self.at);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "// The contract.\n\n// Doc.\nstruct A {\n    b: f32, // b;\n}\n\nalias B = mat2x3f;\n\
        @group(0) @binding(1) var<storage, read> c: array<A>;\n/* } */\nfn d(x: A) -> f32 {\n    if x.b > K { return c[0].b; }\n    return 1e-3;\n}\n";

    #[test]
    fn splits_at_module_scope() {
        let found = declarations(SOURCE);
        let names: Vec<_> = found.iter().map(|d| (d.keyword, d.name, d.line)).collect();
        assert_eq!(names, [("struct", "A", 3), ("alias", "B", 8), ("var", "c", 9), ("fn", "d", 10)]);
        assert!(found[0].text.starts_with("// Doc."));
        assert!(found[0].text.ends_with('}'));
    }

    #[test]
    fn members_are_no_identifiers() {
        let found = declarations(SOURCE);
        let used: Vec<_> = found[3].used().collect();
        assert!(used.contains(&"K") && used.contains(&"c") && used.contains(&"A"));
        assert!(!used.contains(&"b"));
    }

    #[test]
    fn own_names_hide_those_outside() {
        let source = "fn f(steps: u32) -> u32 {\n    let hit = steps;\n    switch hit {\n        case HIT, MISS: {}\n        default: {}\n    }\n    return other;\n}\nstruct S {\n    taken: f32,\n}\n";
        let found = declarations(source);
        let used: Vec<_> = found[0].used().collect();
        for own in ["steps", "hit"] {
            assert!(!used.contains(&own), "{used:?}");
        }
        for outer in ["HIT", "MISS", "other"] {
            assert!(used.contains(&outer), "{used:?}");
        }
        assert!(!found[1].used().any(|name| name == "taken"));
    }
}
