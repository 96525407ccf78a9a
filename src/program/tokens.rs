//! WGSL as tokens: words, numbers and single signs, each with the gap before it and its origin.
//!
//! Code that edits tokens does not depend on how a line is formatted, and
//! errors in edited tokens still report the original file, line and column.

use std::borrow::Cow;
use std::ops::Range;

/// The location at which a token was written.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Origin {
    /// The index of its unit in the program.
    pub(super) unit: usize,
    /// The offset in the unit, in bytes.
    pub(super) at: usize,
}

/// A word, a number or a sign.
#[derive(Debug, Clone)]
pub(super) struct Token<'a> {
    /// The spaces and comments before it.
    pub(super) gap: Cow<'a, str>,
    pub(super) word: Cow<'a, str>,
    pub(super) origin: Origin,
}

/// A text as a sequence of tokens.
#[derive(Debug, Clone, Default)]
pub(super) struct Tokens<'a>(pub(super) Vec<Token<'a>>);

/// A range of tokens, and its replacement.
pub(super) type Splice<'a> = (Range<usize>, Vec<Token<'a>>);

impl<'a> Tokens<'a> {
    /// Tokenizes a text as the first unit of a program. A comment at its end is dropped.
    pub(super) fn of(text: &'a str) -> Self {
        let mut tokens = Vec::new();
        let mut before = 0;
        loop {
            let at = behind_comments(text, before);
            let Some(first) = text[at..].chars().next() else { return Self(tokens) };
            let end = if is_word(first) { behind(text, at, is_word) } else { at + first.len_utf8() };
            let origin = Origin { unit: 0, at };
            tokens.push(Token { gap: text[before..at].into(), word: text[at..end].into(), origin });
            before = end;
        }
    }

    /// Assigns the tokens to the unit with this index.
    pub(super) fn of_unit(mut self, unit: usize) -> Self {
        for token in &mut self.0 {
            token.origin.unit = unit;
        }
        self
    }

    /// Tokenizes text that the linker generates, as the unit with this index.
    pub(super) fn made(text: &str, unit: usize) -> Tokens<'static> {
        let own = |token: Token| Token {
            gap: token.gap.into_owned().into(),
            word: token.word.into_owned().into(),
            origin: Origin { unit, ..token.origin },
        };
        Tokens(Tokens::of(text).0.into_iter().map(own).collect())
    }

    /// Tokenizes a few words with this origin.
    pub(super) fn written_at(text: &str, origin: Origin) -> Vec<Token<'static>> {
        let mut made = Tokens::made(text, origin.unit).0;
        for token in &mut made {
            token.origin = origin;
        }
        made
    }

    /// Returns the replacement of a token, with the gap before the token.
    pub(super) fn replacement(&self, i: usize, text: &str) -> Vec<Token<'static>> {
        let mut new = Self::written_at(text, self.origin(i));
        if let (Some(first), Some(old)) = (new.first_mut(), self.0.get(i)) {
            first.gap = old.gap.clone().into_owned().into();
        }
        new
    }

    /// Returns the tokens with these replacements, which must not overlap.
    pub(super) fn spliced(self, mut splices: Vec<Splice<'a>>) -> Self {
        if splices.is_empty() {
            return self;
        }
        splices.sort_by_key(|(range, _)| (range.start, range.end));
        let mut all = Vec::with_capacity(self.0.len() + splices.len());
        let mut old = self.0.into_iter();
        let mut done = 0;
        for (range, new) in splices {
            all.extend(old.by_ref().take(range.start - done));
            all.extend(new);
            old.by_ref().take(range.len()).for_each(drop);
            done = range.end;
        }
        all.extend(old);
        Self(all)
    }

    /// Returns the text, without a comment at its end.
    #[cfg(test)]
    pub(super) fn text(&self) -> String {
        self.0.iter().flat_map(|token| [&*token.gap, &*token.word]).collect()
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns the origin of a token; after the last token, the origin of the last one.
    pub(super) fn origin(&self, i: usize) -> Origin {
        self.0.get(i).or(self.0.last()).map_or_else(Origin::default, |token| token.origin)
    }

    /// Returns the text of a token; empty after the last one.
    pub(super) fn word(&self, i: usize) -> &str {
        self.0.get(i).map_or("", |token| &*token.word)
    }

    /// Returns the text of the token before this one; empty for the first.
    pub(super) fn before(&self, i: usize) -> &str {
        i.checked_sub(1).map_or("", |i| self.word(i))
    }

    /// Returns `true` if the tokens at these offsets from `i` are these words.
    pub(super) fn are(&self, i: usize, words: &[(usize, &str)]) -> bool {
        words.iter().all(|(k, word)| self.word(i + k) == *word)
    }

    /// Returns `true` for a name or a keyword.
    pub(super) fn is_name(&self, i: usize) -> bool {
        self.word(i).starts_with(|c: char| c.is_alphabetic() || c == '_')
    }

    /// Returns the token that closes the bracket `open`: one of `(`, `[`, `{`, and `<` where a list of template arguments begins.
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

    /// Splits the tokens of `list` at its commas, except commas inside brackets.
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

    /// Returns a type or a simple expression in normalized spelling.
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

    /// Returns the first token after the attributes at `i`.
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

/// Parses a token as a whole number.
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

/// Returns the first position from `at` on that is outside comments and spaces.
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
    // In WGSL the marks of writing direction are spaces.
    behind(text, at, |c| c.is_whitespace() || matches!(c, '\u{200e}' | '\u{200f}'))
}

/// Returns the first position from `at` on whose character is not `wanted`. Most of a program is ASCII, which needs no decoding.
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

/// Returns the length of the comment that `text` begins with; 0 if there is none.
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
