//! Scopes: the tokens of a declaration that refer to names of module scope.
//!
//! Inside a function WGSL has scopes like other languages: a parameter or a local variable hides a module-scope name
//! from the end of its own statement to the end of its block.

use super::signature::Signature;
use super::tokens::Tokens;

/// The names that are known up to the token `end`.
struct Scope<'a> {
    end: usize,
    names: Vec<&'a str>,
}

/// Returns the tokens that refer to names of module scope, including the declaration's own name. `head` is the token of its keyword.
pub(super) fn outer_names(tokens: &Tokens, head: usize) -> Vec<usize> {
    match tokens.word(head) {
        "fn" => in_function(tokens, head),
        "struct" => in_struct(tokens, head),
        "var" if tokens.word(head + 1) == "<" => {
            let space = head + 1..=tokens.closing(head + 1).unwrap_or(head + 1);
            plain(tokens, 0).filter(|i| !space.contains(i)).collect()
        }
        _ => plain(tokens, 0).collect(),
    }
}

/// Returns the tokens that are names, except members after a dot and attributes.
fn plain<'t>(tokens: &'t Tokens<'_>, from: usize) -> impl Iterator<Item = usize> + 't {
    let mut attribute = 0;
    (from..tokens.len()).filter(move |&i| {
        if tokens.word(i) == "@" {
            // The arguments of these attributes are not names of module scope.
            let own = matches!(tokens.word(i + 1), "builtin" | "interpolate" | "diagnostic");
            attribute = if own { tokens.behind_attributes(i) } else { i + 2 };
        }
        i >= attribute && tokens.is_name(i) && tokens.before(i) != "."
    })
}

fn in_struct(tokens: &Tokens, head: usize) -> Vec<usize> {
    let members = match tokens.closing(head + 2) {
        Some(end) => tokens.split(head + 3..end),
        None => Vec::new(),
    };
    let own: Vec<usize> = members.into_iter().map(|member| tokens.behind_attributes(member.start)).collect();
    plain(tokens, 0).filter(|i| !own.contains(i)).collect()
}

fn in_function(tokens: &Tokens, head: usize) -> Vec<usize> {
    let Some(signature) = Signature::of(tokens, head) else { return plain(tokens, 0).collect() };
    let parameters: Vec<usize> = signature.parameters.iter().map(|parameter| parameter.name).collect();
    let mut found = Vec::new();
    let mut scopes: Vec<Scope> = Vec::new();
    // The name that the current statement declares.
    let mut declared = None;
    let mut candidates = plain(tokens, 0).peekable();
    for i in 0..tokens.len() {
        while scopes.last().is_some_and(|scope| scope.end < i) {
            scopes.pop();
        }
        let is_candidate = candidates.next_if_eq(&i).is_some();
        match tokens.word(i) {
            "{" => {
                let names =
                    if i == signature.body { parameters.iter().map(|&i| tokens.word(i)).collect() } else { vec![] };
                scopes.push(Scope { end: tokens.closing(i).unwrap_or(tokens.len()), names });
            }
            "for" => {
                let body = tokens.closing(i + 1).and_then(|header| tokens.closing(header + 1));
                scopes.push(Scope { end: body.unwrap_or(tokens.len()), names: Vec::new() });
            }
            ";" => {
                let scope = scopes.last_mut();
                if let Some((scope, name)) = scope.zip(declared.take()) {
                    scope.names.push(tokens.word(name));
                }
            }
            "let" | "const" if i > head => declared = Some(i + 1),
            "var" if i > head => {
                let space = if tokens.word(i + 1) == "<" { tokens.closing(i + 1) } else { None };
                declared = Some(space.unwrap_or(i) + 1);
            }
            word => {
                let is_hidden = scopes.iter().any(|scope| scope.names.contains(&word));
                if is_candidate && !is_hidden && declared != Some(i) && !parameters.contains(&i) {
                    found.push(i);
                }
            }
        }
    }
    found
}
