//! Inlining of functions that only pass on a value.
//!
//! *Theory.* The simplest implementation of a contract is `return false;`, `return x;`, `return other(x);` or an empty body, as for an
//! empty medium or a law that needs no projection. Readers of the linked program should see only the code that does something.
//!
//! *Practice.* A call is replaced if that cannot change the result: no argument with a call is lost or computed twice, no name
//! means something else there, and a number keeps its type. Conditions that are then constant are decided as features are.

use std::collections::HashMap;
use std::ops::Range;

use super::declarations::Declaration;
use super::expressions::{decided, grouped, has_call, has_variable, is_number, is_path};
use super::fold::folded;
use super::sources::Known;
use super::tokens::{Splice, Token, Tokens};
use super::unit::{Author, Unit};

/// The largest depth of nested calls of such functions.
const ROUNDS: usize = 8;

/// Inlines the calls of functions that only pass on a value. The user's functions are left as they were written.
pub(super) fn inlined<'a>(mut all: Vec<Declaration<'a>>, units: &[Unit]) -> Vec<Declaration<'a>> {
    let is_own = |declaration: &Declaration| units[declaration.origin().unit].author == Author::User;
    for _ in 0..ROUNDS {
        let plain = all.iter().filter(|declaration| !is_own(declaration)).filter_map(Plain::of);
        let plain: HashMap<String, Plain> = plain.map(|function| (function.name.clone(), function)).collect();
        let mut is_over = true;
        for declaration in all.iter_mut().filter(|declaration| declaration.keyword() == "fn" && !is_own(declaration)) {
            let splices = replaced(declaration, &plain);
            if !splices.is_empty() {
                is_over = false;
                *declaration =
                    declaration.clone().spliced(splices).edited(|tokens| folded(decided(tokens), &literals()));
            }
        }
        if is_over {
            break;
        }
    }
    all
}

/// Returns the constants that decide `if true` and `if false` as features are decided.
fn literals() -> Known {
    let bools = [("true".to_owned(), true), ("false".to_owned(), false)];
    Known { bools: bools.into(), ..Known::default() }
}

/// A function that only passes on a value, or does nothing.
struct Plain<'a> {
    name: String,
    /// The names and types of the parameters.
    parameters: Vec<(String, String)>,
    /// The returned value; empty if the function does nothing.
    value: Vec<Token<'a>>,
    /// The names of module scope in the value.
    outer: Vec<String>,
}

impl<'a> Plain<'a> {
    fn of(declaration: &Declaration<'a>) -> Option<Self> {
        let signature = declaration.signature().filter(|_| !declaration.has_attributes())?;
        let tokens = &declaration.tokens;
        let body = signature.body + 1..tokens.len() - 1;
        let value = match (&signature.result, tokens.word(body.start)) {
            (None, _) if body.is_empty() || body.len() == 2 && tokens.word(body.start) == "return" => 0..0,
            (Some(_), "return") if tokens.word(body.end - 1) == ";" => body.start + 1..body.end - 1,
            _ => return None,
        };
        let name = |i: usize| tokens.word(i).to_owned();
        let parameters = signature.parameters.iter().map(|own| (name(own.name), tokens.written(own.ty.clone())));
        let mut own = Self {
            name: declaration.name().to_owned(),
            parameters: parameters.collect(),
            value: tokens.0[value.clone()].to_vec(),
            outer: declaration.names.iter().filter(|i| value.contains(i)).map(|&i| name(i)).collect(),
        };
        if own.value.is_empty() {
            return Some(own);
        }
        if is_number(&own.value) {
            // The value keeps the function's type next to any operand. naga cannot convert a 64-bit constant to a 32-bit number.
            let ty = tokens.written(signature.result?);
            if !["f32", "u32", "i32"].contains(&ty.as_str()) {
                return None;
            }
            let origin = own.value[0].origin;
            own.outer.push(ty.clone());
            own.value[0].gap = "".into();
            own.value.splice(0..0, Tokens::written_at(&format!("{ty}("), origin));
            own.value.extend(Tokens::written_at(")", origin));
            return Some(own);
        }
        let text = Tokens(own.value.clone());
        let is_call = text.word(1) == "(" && text.closing(1) == Some(text.len() - 1);
        let hands_on = is_call && text.split(2..text.len() - 1).into_iter().all(|part| is_path(&text.0[part]));
        // A value made only of constants stays in its function, because naga 30 loses the order of the operations next to it.
        (is_path(&own.value) || hands_on && has_variable(&own.value)).then_some(own)
    }
}

/// Returns a replacement for every call in a function that can be inlined, except calls inside other replaced calls.
fn replaced<'a>(declaration: &Declaration<'a>, plain: &HashMap<String, Plain<'a>>) -> Vec<Splice<'a>> {
    let tokens = &declaration.tokens;
    let mut splices: Vec<Splice> = Vec::new();
    for &i in &declaration.names {
        let Some(function) = plain.get(tokens.word(i)).filter(|_| tokens.word(i + 1) == "(") else { continue };
        let Some(end) = tokens.closing(i + 1) else { continue };
        let is_inside = splices.last().is_some_and(|(range, _)| range.end > i);
        if is_inside || tokens.before(i) == "fn" || hides(declaration, &function.outer) {
            continue;
        }
        let arguments = tokens.split(i + 2..end);
        let is_statement = matches!(tokens.before(i), ";" | "{" | "}") && tokens.word(end + 1) == ";";
        if function.value.is_empty() || is_statement && !has_call(&function.value) {
            if is_statement && !has_call(&tokens.0[i + 2..end]) {
                splices.push((i..end + 2, Vec::new()));
            }
        } else if let Some(mut value) = substituted(tokens, function, &arguments) {
            value[0].gap.clone_from(&tokens.0[i].gap);
            splices.push((i..end + 1, value));
        }
    }
    splices
}

/// Returns `true` if a function has a parameter or a variable with one of these names.
fn hides(declaration: &Declaration, names: &[String]) -> bool {
    let tokens = &declaration.tokens;
    names.iter().any(|name| {
        let is_local = |i: usize| tokens.word(i) == name && tokens.before(i) != "." && !declaration.names.contains(&i);
        (0..tokens.len()).any(is_local)
    })
}

/// Returns the value with these arguments, or `None` if that would change the result.
fn substituted<'a>(tokens: &Tokens<'a>, function: &Plain<'a>, arguments: &[Range<usize>]) -> Option<Vec<Token<'a>>> {
    let mut value = Vec::new();
    let places =
        function.value.iter().filter_map(|token| function.parameters.iter().position(|own| own.0 == token.word));
    let calls = arguments.iter().any(|argument| has_call(&tokens.0[argument.clone()]));
    // A call may change variables that the other operands read, so the order of evaluation must not change.
    if calls && !(places.is_sorted() && function.outer.len() < 2) {
        return None;
    }
    let uses = |name: &str| {
        let words = function.value.iter().enumerate();
        let is_use =
            |(k, token): &(usize, &Token)| token.word == name && (*k == 0 || function.value[k - 1].word != ".");
        words.filter(is_use).count()
    };
    for ((name, ty), argument) in function.parameters.iter().zip(arguments) {
        let own = &tokens.0[argument.clone()];
        let fits = match uses(name) {
            0 => !has_call(own),
            // A constant may get another type, or a type that naga cannot convert to.
            1 => (is_path(own) || has_variable(own)) && !ty.starts_with("ptr"),
            _ => is_path(own),
        };
        if !fits {
            return None;
        }
    }
    for (k, token) in function.value.iter().enumerate() {
        let is_member = k > 0 && function.value[k - 1].word == ".";
        let place = function.parameters.iter().position(|(name, _)| *name == token.word).filter(|_| !is_member);
        let Some(argument) = place.map(|place| &tokens.0[arguments[place].clone()]) else {
            value.push(token.clone());
            continue;
        };
        let is_argument = matches!(function.value.get(k + 1).map(|next| &*next.word), Some("," | ")"));
        let mut own = if is_argument { argument.to_vec() } else { grouped(argument) };
        own[0].gap.clone_from(&token.gap);
        value.extend(own);
    }
    Some(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::declarations::declarations;

    /// Returns the function `f` with these statements after inlining, from a program with functions that pass on values.
    fn left(statements: &str) -> String {
        let text = format!(
            "fn nothing(a: u32) {{\n}}\nfn no() -> bool {{ return false; }}\nfn yes(x: f32) -> bool {{ return true; }}\n\
             fn one() -> f32 {{ return 1.0; }}\nfn black() -> vec3f {{ return vec3f(0.0); }}\nfn same(x: f32) -> f32 {{ return x; }}\nfn member() -> f32 {{ return sky.color; }}\n\
             fn other(x: f32, y: f32) -> f32 {{ return long(y, x); }}\nfn third(x: f32) -> f32 {{ return same(x); }}\n\
             fn f(t: f32) {{ {statements} }}"
        );
        let units = [Unit::generated("a.wgsl", text.clone())];
        let all = inlined(declarations(Tokens::of(&text)).unwrap(), &units);
        let text = all.last().unwrap().tokens.text();
        let body = text.trim().trim_start_matches("fn f(t: f32) {").trim_end_matches('}');
        body.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn what_only_hands_on_a_value_is_written_where_it_is_called() {
        for (text, expected) in [
            ("nothing(a.b); g();", "g();"),
            ("nothing(g());", "nothing(g());"),
            ("let a = one() * t;", "let a = f32(1.0) * t;"),
            ("let a = 2.0 * same(t + 1.0);", "let a = 2.0 * (t + 1.0);"),
            ("let a = third(g(t)).x;", "let a = g(t).x;"),
            ("let a = same(0.5);", "let a = same(0.5);"),
            ("let a = same(Real(0.5));", "let a = same(Real(0.5));"),
            ("same(t); other(t, t); no(); g();", "long(t, t); g();"),
            ("let a = black();", "let a = black();"),
            ("nothing((*t).x);", ""),
            ("let a = other(t, a + b);", "let a = long(a + b, t);"),
            ("let a = other(g(t), h(t));", "let a = other(g(t), h(t));"),
            ("let a = member();", "let a = sky.color;"),
            ("let sky = 1.0; let a = member();", "let sky = 1.0; let a = member();"),
        ] {
            assert_eq!(left(text), expected, "{text}");
        }
    }

    #[test]
    fn conditions_are_decided() {
        for (text, expected) in [
            ("if no() { g(); } h();", "h();"),
            ("if !no() { g(); } h();", "g(); h();"),
            ("if no() || t > 1.0 { g(); }", "if t > 1.0 { g(); }"),
            ("if t > 1.0 && yes(t) { g(); }", "if t > 1.0 { g(); }"),
            ("if no() && g(t) || t > 1.0 { g(); }", "if t > 1.0 { g(); }"),
            ("if no() && g(t) { g(); }", ""),
            ("if g(t) && no() { g(); }", "if g(t) && false { g(); }"),
            ("if !(yes(t) && yes(t)) { g(); }", ""),
            ("while g(t) || no() { h(); }", "while g(t) { h(); }"),
            ("let a = select(b, c + d, no());", "let a = b;"),
            ("let a = 2.0 * select(b, c + d, yes(t));", "let a = 2.0 * (c + d);"),
            ("let a = yes(t) == no();", "let a = true == false;"),
        ] {
            assert_eq!(left(text), expected, "{text}");
        }
    }
}
