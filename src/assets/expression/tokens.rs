//! The words and signs of a formula.

use super::{FormulaError, Language};
use crate::document::values::{LARGEST, SMALLEST};
use std::ops::Range;

/// A number, a name or a sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Token<'a> {
    /// A number that is 0 or between 10⁻³⁰ and 10³⁰ in magnitude.
    Number(f64),
    /// The name of a variable or a function.
    Name(&'a str),
    /// One of `+-*/^(),`.
    Sign(char),
}

/// Splits a text into tokens, each with its range of bytes.
pub fn tokens<'a>(text: &'a str, language: &Language) -> Result<Vec<(Token<'a>, Range<usize>)>, FormulaError> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let (token, length) = if first.is_whitespace() {
            at += first.len_utf8();
            continue;
        } else if first.is_ascii_digit() || first == '.' {
            let length = number_length(rest);
            (Token::Number(number(&rest[..length], at)?), length)
        } else if first.is_alphabetic() || first == '_' {
            let length =
                rest.find(|c: char| !c.is_alphabetic() && !c.is_ascii_digit() && c != '_').unwrap_or(rest.len());
            (Token::Name(&rest[..length]), length)
        } else if "+-*/^(),".contains(first) {
            // `**` is the power operator of other languages.
            if rest.starts_with("**") {
                return Err(wrong(at..at + 2, "unknown operator `**`", "write powers with ^"));
            }
            (Token::Sign(first), 1)
        } else {
            let help = match first {
                '²' | '³' => "write powers with ^, such as r^2".to_owned(),
                '−' | '–' => "write minus as -".to_owned(),
                '·' | '×' => "write multiplication as *".to_owned(),
                '[' | '{' => "use ( and ) as parentheses".to_owned(),
                _ => {
                    let names: Vec<&str> = language.known().collect();
                    format!("use numbers, {}, functions, + - * / ^ ( ) and ,", names.join(", "))
                }
            };
            return Err(wrong(at..at + first.len_utf8(), format!("unexpected character `{first}`"), help));
        };
        found.push((token, at..at + length));
        at += length;
    }
    Ok(found)
}

pub fn wrong(place: Range<usize>, problem: impl Into<String>, help: impl Into<String>) -> FormulaError {
    FormulaError { place, problem: problem.into(), help: help.into() }
}

/// Returns the length of a number: digits, a point, digits, and an exponent if digits follow it; `2 e` is a number and a name.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let mut length = digits(0);
    if bytes.get(length) == Some(&b'.') {
        length += 1;
        length += digits(length);
    }
    if matches!(bytes.get(length), Some(b'e' | b'E')) {
        let signed = length + 1 + usize::from(matches!(bytes.get(length + 1), Some(b'+' | b'-')));
        let exponent = bytes.get(signed..).map_or(0, |_| digits(signed));
        if exponent > 0 {
            length = signed + exponent;
        }
    }
    length
}

fn number(word: &str, at: usize) -> Result<f64, FormulaError> {
    let place = at..at + word.len();
    let help = "use 0, or a magnitude from 1e-30 to 1e30";
    match word.parse::<f64>() {
        Ok(value) if value == 0.0 || (SMALLEST..=LARGEST).contains(&value) => Ok(value),
        Ok(_) => Err(wrong(place, "outside the range of 32-bit floats", help)),
        Err(_) => Err(wrong(place, format!("expected a number, found `{word}`"), help)),
    }
}
