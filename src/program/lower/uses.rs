//! Analysis of the uses of a uniform, which determine its copy.

use std::collections::HashMap;
use std::ops::Range;

use super::super::declarations::Declaration;
use super::super::tokens::{Tokens, whole_number};

/// The copy of a uniform.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// The whole uniform.
    Whole,
    /// The only element of an array, of this type.
    One(String),
    /// The first elements of an array: their type and number.
    Places(String, u32),
    /// No copy: the uniform is read in place.
    InPlace,
}

/// The largest number of elements that are copied one by one; an unrolled list has at most 32.
const MOST_PLACES: u32 = 64;
/// The largest length of a chain of aliases and constants that is followed.
const STEPS: usize = 8;

/// The declarations that a program reaches, by name.
type ByName<'a> = HashMap<&'a str, &'a Declaration<'a>>;

/// Returns the possible copy of a uniform, given all its uses.
pub(super) fn shape(uniform: &Declaration, reached: &[&Declaration], by_name: &ByName) -> Shape {
    let uses = || {
        let functions = reached.iter().filter(|declaration| declaration.keyword() == "fn");
        let all = functions.flat_map(|function| function.names.iter().map(move |&i| (&function.tokens, i)));
        all.filter(|(tokens, i)| tokens.word(*i) == uniform.name())
    };
    if uses().any(|(tokens, i)| is_written(tokens, i) || is_pointed_at(tokens, i)) {
        return Shape::InPlace;
    }
    let Some((element, count)) = array(uniform, by_name) else { return Shape::Whole };
    let Some(count) = count else { return Shape::InPlace };
    let are_one = count == 1
        && uses().all(|(tokens, i)| {
            let inside = i + 1..index_end(tokens, i);
            let calls = |i| by_name.get(tokens.word(i)).is_some_and(|named| named.keyword() == "fn");
            !inside.is_empty() && written_place(tokens, i).is_none_or(|k| k == 0) && !inside.into_iter().any(calls)
        });
    if are_one {
        return Shape::One(element);
    }
    let places = uses().map(|(tokens, i)| written_place(tokens, i).filter(|k| *k < count.min(MOST_PLACES)));
    places
        .collect::<Option<Vec<_>>>()
        .map_or(Shape::InPlace, |all| Shape::Places(element, all.into_iter().max().map_or(0, |last| last + 1)))
}

/// Returns the type and the number of an array's elements; the number is `None` if it is unknown.
fn array(uniform: &Declaration, by_name: &ByName) -> Option<(String, Option<u32>)> {
    let (mut tokens, mut ty) = (&uniform.tokens, uniform.ty()?);
    for _ in 0..STEPS {
        match by_name.get(tokens.word(ty.start)).filter(|named| ty.len() == 1 && named.keyword() == "alias") {
            Some(alias) => (tokens, ty) = (&alias.tokens, alias.value()?),
            None => break,
        }
    }
    if tokens.word(ty.start) != "array" {
        return None;
    }
    let arguments = tokens.split(ty.start + 2..tokens.closing(ty.start + 1)?);
    let count = arguments.get(1).and_then(|count| number(tokens, count.clone(), by_name));
    Some((tokens.written(arguments.first()?.clone()), count))
}

/// Evaluates a number, or the name of a constant number.
fn number<'a>(mut tokens: &'a Tokens<'a>, mut value: Range<usize>, by_name: &'a ByName<'a>) -> Option<u32> {
    for _ in 0..STEPS {
        if value.len() != 1 {
            return None;
        }
        let word = tokens.word(value.start);
        let Some(constant) = by_name.get(word).filter(|named| named.keyword() == "const") else {
            return whole_number(word);
        };
        (tokens, value) = (&constant.tokens, constant.value()?);
    }
    None
}

/// Returns the token that closes the index after the name `i`, or `i` if there is none.
pub(super) fn index_end(tokens: &Tokens, i: usize) -> usize {
    if tokens.word(i + 1) == "[" { tokens.closing(i + 1).unwrap_or(i) } else { i }
}

/// Returns the index of the name `i`, if it is a literal number.
pub(super) fn written_place(tokens: &Tokens, i: usize) -> Option<u32> {
    (index_end(tokens, i) == i + 3).then(|| whole_number(tokens.word(i + 2)))?
}

/// Returns `true` if a statement writes to the name `i`, or to a part of it.
fn is_written(tokens: &Tokens, i: usize) -> bool {
    let mut k = i + 1;
    loop {
        match tokens.word(k) {
            "." => k += 2,
            "[" => k = tokens.closing(k).unwrap_or(k) + 1,
            ")" => k += 1,
            _ => break,
        }
    }
    let [first, second, third] = [0, 1, 2].map(|n| tokens.word(k + n));
    match (first, second) {
        ("=", _) => second != "=",
        ("+" | "-" | "*" | "/" | "%" | "&" | "|" | "^", "=") => true,
        ("<", "<") | (">", ">") => third == "=",
        ("+", "+") | ("-", "-") => tokens.0[k + 1].gap.is_empty(),
        _ => false,
    }
}

/// Returns `true` if the address of the name `i` is taken.
fn is_pointed_at(tokens: &Tokens, i: usize) -> bool {
    let mut first = i;
    while tokens.before(first) == "(" {
        first -= 1;
    }
    if tokens.before(first) != "&" {
        return false;
    }
    // In `a & b` and `a && b`, a value or another operator precedes the sign.
    let before = tokens.before(first - 1);
    let is_operand = matches!(before, ")" | "]" | "&") || before.starts_with(|c: char| c.is_alphanumeric() || c == '_');
    !is_operand || before == "return"
}
