//! WGSL text as tokens: words, numbers and single signs. Spaces and comments only stand between them, so that what works on tokens
//! does not depend on how a line is formatted.

use std::ops::Range;

/// The tokens of a text, each by where it stands.
#[derive(Debug, Clone)]
pub(super) struct Tokens<'a> {
    pub(super) text: &'a str,
    ranges: Vec<Range<usize>>,
}

impl<'a> Tokens<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        let mut ranges = Vec::new();
        let mut at = behind_comments(text, 0);
        while let Some(first) = text[at..].chars().next() {
            let end = if is_word(first) { behind(text, at, is_word) } else { at + first.len_utf8() };
            ranges.push(at..end);
            at = behind_comments(text, end);
        }
        Self { text, ranges }
    }

    /// Those of `tokens`, in the text from `start` on: where they stand is counted from there.
    pub(super) fn part(&self, start: usize, tokens: Range<usize>) -> Self {
        let end = self.ranges[tokens.end - 1].end;
        let ranges = self.ranges[tokens].iter().map(|range| range.start - start..range.end - start).collect();
        Self { text: &self.text[start..end], ranges }
    }

    pub(super) fn len(&self) -> usize {
        self.ranges.len()
    }

    /// Where a token stands.
    pub(super) fn range(&self, i: usize) -> Range<usize> {
        self.ranges[i].clone()
    }

    /// A token's text; empty behind the last one.
    pub(super) fn word(&self, i: usize) -> &'a str {
        self.ranges.get(i).map_or("", |range| &self.text[range.clone()])
    }

    /// The text of the token before this one; empty for the first.
    pub(super) fn before(&self, i: usize) -> &'a str {
        i.checked_sub(1).map_or("", |i| self.word(i))
    }

    /// Is it a name, or a word of the language?
    pub(super) fn is_name(&self, i: usize) -> bool {
        self.word(i).starts_with(|c: char| c.is_alphabetic() || c == '_')
    }

    /// The token that closes the bracket `open`: one of `(`, `[`, `{`, and `<` where a list of template arguments begins.
    pub(super) fn closing(&self, open: usize) -> Option<usize> {
        let mut opened = Vec::new();
        for i in open..self.len() {
            let is_template = i == open || opened.last() == Some(&"<");
            match self.word(i) {
                sign @ ("(" | "[" | "{") => opened.push(sign),
                "<" if is_template => opened.push("<"),
                ">" if is_template => drop(opened.pop()),
                ")" | "]" | "}" => {
                    opened.truncate(1 + opened.iter().rposition(|sign| *sign != "<")?);
                    opened.pop();
                }
                _ => {}
            }
            if opened.is_empty() {
                return Some(i);
            }
        }
        None
    }

    /// The tokens of `list` cut at its commas, but for those inside of brackets.
    pub(super) fn split(&self, list: Range<usize>) -> Vec<Range<usize>> {
        let mut pieces = Vec::new();
        let (mut from, mut i) = (list.start, list.start);
        while i < list.end {
            match self.word(i) {
                "(" | "[" | "{" | "<" => i = self.closing(i).unwrap_or(i),
                "," => {
                    pieces.push(from..i);
                    from = i + 1;
                }
                _ => {}
            }
            i += 1;
        }
        pieces.push(from..list.end);
        pieces.retain(|piece| !piece.is_empty());
        pieces
    }

    /// A type or a simple expression, written the one way.
    pub(super) fn written(&self, tokens: Range<usize>) -> String {
        let mut text = String::new();
        for i in tokens {
            match self.word(i) {
                "," if matches!(self.word(i + 1), ">" | ")") => {}
                "," => text += ", ",
                word => {
                    let last = text.chars().last();
                    if last.is_some_and(is_word) && word.starts_with(is_word) {
                        text.push(' ');
                    }
                    text += word;
                }
            }
        }
        text
    }

    /// The first token behind the attributes that stand at `i`.
    pub(super) fn behind_attributes(&self, mut i: usize) -> usize {
        while self.word(i) == "@" {
            i += 2;
            if self.word(i) == "(" {
                i = self.closing(i).unwrap_or(self.len()) + 1;
            }
        }
        i
    }
}

/// The whole number that a token is.
pub(super) fn whole_number(word: &str) -> Option<u32> {
    let digits = word.trim_end_matches(['u', 'i']);
    match digits.strip_prefix("0x").or(digits.strip_prefix("0X")) {
        Some(hex) => u32::from_str_radix(hex, 16).ok(),
        None => digits.parse().ok(),
    }
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The first place from `at` on that is in no comment and no space.
pub(super) fn behind_comments(text: &str, mut at: usize) -> usize {
    loop {
        at = behind_spaces(text, at);
        match comment(&text[at..]) {
            0 => return at,
            length => at += length,
        }
    }
}

pub(super) fn behind_spaces(text: &str, at: usize) -> usize {
    // WGSL counts the marks of writing direction as spaces.
    behind(text, at, |c| c.is_whitespace() || matches!(c, '\u{200e}' | '\u{200f}'))
}

/// The first place from `at` on whose character is not `wanted`. Most of a program is ASCII, which needs no decoding.
fn behind(text: &str, mut at: usize, wanted: impl Fn(char) -> bool) -> usize {
    while let Some(&byte) = text.as_bytes().get(at) {
        let next = if byte.is_ascii() { char::from(byte) } else { text[at..].chars().next().unwrap_or_default() };
        if !wanted(next) {
            break;
        }
        at += next.len_utf8();
    }
    at
}

/// The length of the comment that `text` begins with; 0 if there is none.
pub(super) fn comment(text: &str) -> usize {
    if text.starts_with("//") {
        return behind(text, 2, |c| !matches!(c, '\n' | '\u{b}' | '\u{c}' | '\r' | '\u{85}' | '\u{2028}' | '\u{2029}'));
    }
    if !text.starts_with("/*") {
        return 0;
    }
    let (mut at, mut depth) = (2, 1_usize);
    while let Some(sign) = text[at..].find(['/', '*']) {
        at += sign;
        let step = match &text[at..text.len().min(at + 2)] {
            "/*" => Some(depth + 1),
            "*/" => Some(depth - 1),
            _ => None,
        };
        at += if step.is_some() { 2 } else { 1 };
        depth = step.unwrap_or(depth);
        if depth == 0 {
            return at;
        }
    }
    text.len()
}
