//! Checks of the user's WGSL before it is linked.
//!
//! *Theory.* A user's file replaces a built-in module, so it must satisfy everything that other modules rely on: it has the functions that
//! they call, with the expected types; none of its names has another meaning in the other modules; it has no bindings; and
//! its loops end after a number of iterations that is visible in the code, because software devices stop long invocations silently. naga
//! finds all other errors in the linked program.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use super::declarations::{Declaration, declarations};
use super::location::Location;
use super::parts::part_tokens;
use super::tokens::{Origin, Tokens, whole_number};
use super::unit::Unit;
use super::{ProgramError, all_parts};
use crate::model::{Promise, UserWgsl};

/// WGSL functions that devices compute inaccurately, or in 32 bits instead of 64, and the replacements in the program.
const INEXACT: [(&[&str], &str); 4] = [
    (&["sin", "cos", "tan"], "`real_sin_cos(a)`, whose x is the sine and y the cosine"),
    (&["exp", "exp2", "sinh", "cosh", "tanh"], "`real_exp`"),
    (&["log", "log2", "pow"], "`real_log` and `real_exp`"),
    (&["atan", "atan2", "asin", "acos"], "`arc_tangent(y, x)`"),
];

/// Checks the file, and returns it with the modules that supply the functions it leaves out.
pub(super) fn checked(own: &UserWgsl) -> Result<(Unit, Vec<&'static str>), ProgramError> {
    let unit = Unit::user(own.file.clone(), own.text.to_string());
    let refuse = |origin: Origin, message: String| ProgramError::invalid(Location::in_unit(&unit, origin.at), message);
    let found = declarations(Tokens::of(&unit.text)).map_err(|slip| refuse(slip.origin, slip.message))?;
    for declaration in &found {
        if let Some((origin, message)) = unfit(declaration) {
            return Err(refuse(origin, message));
        }
    }
    let promised: Vec<&str> = own.promises.iter().map(Promise::name).collect();
    let meant = names_of_parts();
    if let Some(declaration) = found.iter().find(|d| !promised.contains(&d.name()) && meant.contains(d.name())) {
        let place = Location::in_unit(&unit, declaration.origin().at);
        return Err(ProgramError::Reserved { place, name: declaration.name().to_owned() });
    }
    let mut usual = Vec::new();
    for promise in &own.promises {
        match (found.iter().find(|declaration| declaration.name() == promise.name()), promise.usual) {
            (Some(declaration), _) if kept(declaration, promise) => {}
            (Some(declaration), _) => {
                return Err(refuse(declaration.origin(), format!("expected `{}`", promise.signature)));
            }
            (None, Some(part)) => usual.push(part),
            (None, None) => {
                let message = format!("the file must declare `{}`", promise.signature);
                return Err(refuse(Origin { unit: 0, at: unit.text.len() }, message));
            }
        }
    }
    Ok((unit, usual))
}

/// Returns the names in the modules of `shaders/`, both declared names and names of WGSL.
fn names_of_parts() -> &'static BTreeSet<String> {
    static NAMES: LazyLock<BTreeSet<String>> = LazyLock::new(|| {
        let tokens = all_parts().into_iter().filter_map(|part| part_tokens(part.file));
        let all = tokens.flat_map(|tokens| declarations(tokens).unwrap_or_default());
        all.flat_map(|declaration| declaration.used().map(str::to_owned).collect::<Vec<_>>()).collect()
    });
    &NAMES
}

/// Returns the first construct that a user's file may not contain, with its location.
fn unfit(declaration: &Declaration) -> Option<(Origin, String)> {
    let tokens = &declaration.tokens;
    let at = |i: usize| tokens.origin(i);
    if tokens.word(0) == "@" {
        let message = "attributes and bindings are not allowed here; declare parameters in the scene";
        return Some((at(0), message.to_owned()));
    }
    if declaration.keyword() == "override" {
        return Some((at(0), "`override` is not allowed here; use `const`".to_owned()));
    }
    let private = ["var", "<", "private", ">"];
    if declaration.keyword() == "var" && (0..4).any(|i| tokens.word(i) != private[i]) {
        return Some((at(0), "a module variable must be `var<private>`".to_owned()));
    }
    if declaration.keyword() != "fn" {
        return None;
    }
    (0..tokens.len()).find_map(|i| match tokens.word(i) {
        word @ ("loop" | "while") => Some((
            at(i),
            format!(
                "`{word}` is not allowed, because it may never end; use `for (var i = 0u; i < 8u; i++)` with \
                 constant bounds"
            ),
        )),
        "for" if length(tokens, i).is_none() => {
            let message = "a loop must have constant bounds, as in `for (var i = 0u; i < 8u; i++)`, and must not \
                           change its counter";
            Some((at(i), message.to_owned()))
        }
        word if tokens.word(i + 1) == "(" && tokens.before(i) != "fn" => {
            let (_, instead) = INEXACT.iter().find(|(names, _)| names.contains(&word))?;
            Some((at(i), format!("the built-in `{word}` is inaccurate in 32 bits and wrong in 64 bits: use {instead}")))
        }
        _ => None,
    })
}

/// Returns the number of iterations of the `for` loop at this token, if it is visible: from one number to another, in steps of one.
fn length(tokens: &Tokens, at: usize) -> Option<u64> {
    let (open, close) = (at + 1, tokens.closing(at + 1)?);
    let head: Vec<&str> = (open + 1..close).map(|i| tokens.word(i)).collect();
    let head: Vec<&str> = head.into_iter().filter(|word| !matches!(*word, "u32" | "i32" | ":")).collect();
    let ["var", name, "=", from, ";", test, "<", to, ";", step, "+", "+"] = head[..] else { return None };
    if test != name || step != name || tokens.word(close + 1) != "{" {
        return None;
    }
    let body = close + 1..tokens.closing(close + 1)?;
    let is_written = |i: usize| {
        let (next, after) = (tokens.word(i + 1), tokens.word(i + 2));
        let assigned = (next == "=" && after != "=")
            || (matches!(next, "+" | "-" | "*" | "/" | "%" | "&" | "|" | "^") && matches!(after, "=" | "+" | "-"));
        tokens.word(i) == name && (assigned || tokens.before(i) == "&" || matches!(tokens.before(i), "var" | "let"))
    };
    if body.clone().any(is_written) {
        return None;
    }
    Some(u64::from(whole_number(to)?.saturating_sub(whole_number(from)?)))
}

/// Returns `true` if the declaration has the promised types.
fn kept(declaration: &Declaration, promise: &Promise) -> bool {
    let wanted = declarations_of(promise);
    let types = |declaration: &Declaration| {
        let signature = declaration.signature()?;
        let all = signature.parameters.iter().map(|parameter| parameter.ty.clone()).chain(signature.result);
        Some(all.map(|ty| declaration.tokens.written(ty)).collect::<Vec<_>>())
    };
    let wanted = declarations(Tokens::of(&wanted)).unwrap_or_default();
    wanted.first().is_some_and(|wanted| types(declaration).is_some_and(|own| Some(own) == types(wanted)))
}

/// Returns the promise as WGSL.
fn declarations_of(promise: &Promise) -> String {
    format!("{} {{}}", promise.signature)
}
