//! Sources of numbers: words of lines, or bytes.

use super::super::bytes::Bytes;
use super::header::{Element, Property};
use crate::assets::Stored;
use crate::assets::format_error::{FormatError, are_padding};
use crate::progress::Stage;

/// An error at the current position of a source.
pub(super) struct Wrong {
    pub problem: String,
    pub help: String,
}

impl Wrong {
    fn new(problem: String) -> Self {
        Self { problem, help: String::new() }
    }
}

/// A sequence of numbers.
pub(super) trait NumberSource {
    /// Returns the smallest size of a number in bytes.
    fn least(kind: Stored) -> u64;

    /// Returns the number of bytes that are left.
    fn left(&self) -> u64;

    /// Begins the next element.
    fn begin(&mut self, element: &Element) -> Result<(), Wrong>;

    /// Fails if more data follows than the header declares, because the mesh would lack it.
    fn end(&mut self) -> Result<(), Wrong>;

    /// Reads the next number.
    fn number(&mut self, kind: Stored) -> Result<f64, Wrong>;

    /// Checks that the source can contain as many elements as the header declares.
    fn has(&self, element: &Element) -> Result<(), Wrong> {
        let (count, name, left) = (element.count, &element.name, self.left());
        let least = element.least(Self::least);
        if count > 0 && least == 0 {
            return Err(Wrong::new(format!("{count} elements `{name}` have no properties")));
        }
        // The last word needs no separator after it.
        if count.saturating_mul(least) > left + 1 {
            let problem = format!(
                "the header declares {count} elements `{name}` of at least {least} bytes, and {left} bytes remain"
            );
            return Err(Wrong::new(problem));
        }
        Ok(())
    }

    /// Reads the length of a list.
    fn length(&mut self, kind: Stored, property: &Property) -> Result<u64, Wrong> {
        let (count, left) = (self.number(kind)?, self.left());
        if !(0.0..=left as f64 / Self::least(property.kind) as f64 + 1.0).contains(&count) || count.fract() != 0.0 {
            let name = &property.name;
            return Err(Wrong::new(format!("a list `{name}` has the length {count}, and {left} bytes remain")));
        }
        Ok(count as u64)
    }
}

/// A source of words, in which an element is a line.
pub(super) struct Words<'a> {
    text: &'a str,
    /// The current line, and the word that was read last.
    line: (usize, usize),
    word: (usize, usize),
    /// The stage to which lines are reported.
    stage: &'a Stage,
}

impl<'a> Words<'a> {
    pub fn of(text: &'a str, stage: &'a Stage) -> Self {
        Self { text, line: (0, 0), word: (0, 0), stage }
    }

    /// Returns the last word; empty if one is missing.
    pub fn last(&self) -> &'a str {
        &self.text[self.word.0..self.word.1]
    }

    /// Returns the next word of the line; `None` at its end.
    fn next(&mut self) -> Option<&'a str> {
        let rest = self.text.get(self.word.1..self.line.1).unwrap_or_default();
        let word = rest.split_ascii_whitespace().next();
        // A missing word would be after the end of the line.
        let start = match word {
            Some(word) => word.as_ptr() as usize - self.text.as_ptr() as usize,
            None => self.word.1 + rest.trim_ascii_end().len(),
        };
        self.word = (start, start + word.map_or(0, str::len));
        word
    }
}

impl NumberSource for Words<'_> {
    /// One digit and a separator.
    fn least(_: Stored) -> u64 {
        2
    }

    fn left(&self) -> u64 {
        (self.text.len() - self.word.1) as u64
    }

    fn begin(&mut self, element: &Element) -> Result<(), Wrong> {
        if let Some(word) = self.next() {
            return Err(Wrong::new(format!("the header declares no value `{word}` for the element on this line")));
        }
        self.stage.reach(self.line.1 as f64);
        loop {
            let start = self.line.1;
            let rest = &self.text[start..];
            if rest.is_empty() {
                self.word = (start, start);
                let (count, name) = (element.count, &element.name);
                return Err(Wrong::new(format!(
                    "unexpected end of file: the header declares {count} elements `{name}`"
                )));
            }
            let length = rest.find('\n').map_or(rest.len(), |i| i + 1);
            self.line = (start, start + length);
            self.word = (start, start);
            if !rest[..length].trim_ascii().is_empty() {
                return Ok(());
            }
        }
    }

    fn end(&mut self) -> Result<(), Wrong> {
        let more = self.next().or_else(|| {
            self.line = (self.line.1, self.text.len());
            self.next()
        });
        more.map_or(Ok(()), |word| {
            Err(Wrong::new(format!("`{word}` follows the last element that the header declares")))
        })
    }

    fn number(&mut self, _: Stored) -> Result<f64, Wrong> {
        match self.next() {
            Some(word) => word.parse().map_err(|_| Wrong::new(format!("expected a number, found `{word}`"))),
            None => Err(Wrong::new("the line ends, and the header declares more numbers".to_owned())),
        }
    }
}

/// A source of bytes.
pub(super) struct Binary<'a> {
    bytes: Bytes<'a>,
    /// The offset of the last number.
    last: usize,
    is_big: bool,
    /// The stage to which elements are reported.
    stage: &'a Stage,
}

impl<'a> Binary<'a> {
    pub fn of(bytes: &'a [u8], at: usize, is_big: bool, stage: &'a Stage) -> Self {
        Self { bytes: Bytes::from(bytes, at), last: at, is_big, stage }
    }

    pub fn flaw(&self, wrong: &Wrong) -> FormatError {
        let help = if wrong.help.is_empty() { String::new() } else { format!(" ({})", wrong.help) };
        FormatError::at(self.last, &format!("{}{help}", wrong.problem))
    }
}

impl NumberSource for Binary<'_> {
    fn least(kind: Stored) -> u64 {
        kind.bytes() as u64
    }

    fn left(&self) -> u64 {
        self.bytes.left() as u64
    }

    fn begin(&mut self, _: &Element) -> Result<(), Wrong> {
        self.stage.reach(self.bytes.at as f64);
        Ok(())
    }

    fn end(&mut self) -> Result<(), Wrong> {
        self.last = self.bytes.at;
        let rest = self.bytes.rest();
        if are_padding(rest) {
            return Ok(());
        }
        Err(Wrong::new(format!("{} bytes follow the last element that the header declares", rest.len())))
    }

    fn number(&mut self, kind: Stored) -> Result<f64, Wrong> {
        self.last = self.bytes.at;
        let size = kind.bytes();
        let short = |_| Wrong::new(format!("unexpected end of file, expected {size} more bytes"));
        Ok(kind.number(self.bytes.take_some(size).map_err(short)?, !self.is_big))
    }
}
