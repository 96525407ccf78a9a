//! Expressions as tokens: properties that need no parser, and simplification of partly known conditions.

use super::tokens::{Splice, Token, Tokens};

/// Returns `true` for a name, members of a name, `true` or `false`.
pub(super) fn is_path(tokens: &[Token]) -> bool {
    tokens.iter().enumerate().all(|(i, token)| if i % 2 == 0 { is_word(token) } else { token.word == "." })
        && tokens.len() % 2 == 1
}

/// Returns `true` if the expression contains a call.
pub(super) fn has_call(tokens: &[Token]) -> bool {
    tokens.windows(2).any(|pair| pair[1].word == "(" && is_word(&pair[0]))
}

/// Returns `true` if the expression contains names other than constants and called functions.
pub(super) fn has_variable(tokens: &[Token]) -> bool {
    let is_constant = |word: &str| matches!(word, "true" | "false") || !word.contains(|c: char| c.is_lowercase());
    let is_called = |i: usize| tokens.get(i + 1).is_some_and(|next| next.word == "(");
    (0..tokens.len()).any(|i| is_word(&tokens[i]) && !is_called(i) && !is_constant(&tokens[i].word))
}

fn is_word(token: &Token) -> bool {
    token.word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// Returns `true` if the expression consists of numbers only.
pub(super) fn is_number(tokens: &[Token]) -> bool {
    !tokens.iter().any(is_word)
}

/// Returns an expression as an operand: in parentheses, unless it is a name or a call.
pub(super) fn grouped<'a>(expression: &[Token<'a>]) -> Vec<Token<'a>> {
    let tokens = Tokens(expression.to_vec());
    let is_call = tokens.word(1) == "(" && tokens.is_name(0) && tokens.closing(1) == Some(tokens.len() - 1);
    let mut own = tokens.0;
    own[0].gap = "".into();
    if !is_call && !is_path(expression) {
        let origin = own[0].origin;
        own.splice(0..0, Tokens::written_at("(", origin));
        own.extend(Tokens::written_at(")", origin));
    }
    own
}

/// Simplifies partly known conditions: `a && true`, `false || a`, `!false` and `select(a, b, false)`.
pub(super) fn decided(mut tokens: Tokens) -> Tokens {
    while let Some(splice) = (0..tokens.len()).find_map(|i| decision(&tokens, i)) {
        tokens = tokens.spliced(vec![splice]);
    }
    tokens
}

/// Returns the simplification that the literal at token `i` allows.
fn decision<'a>(tokens: &Tokens<'a>, i: usize) -> Option<Splice<'a>> {
    let value = match tokens.word(i) {
        "true" => true,
        "false" => false,
        _ => return None,
    };
    if tokens.before(i) == "!" {
        return Some((i - 1..i + 1, tokens.replacement(i - 1, if value { "false" } else { "true" })));
    }
    let groups = i > 1 && tokens.before(i) == "(" && tokens.word(i + 1) == ")" && !tokens.is_name(i - 2);
    if groups {
        return Some((i - 1..i + 2, tokens.replacement(i - 1, tokens.word(i))));
    }
    let is_pair = |k: usize| matches!(tokens.word(k), "&" | "|") && tokens.word(k + 1) == tokens.word(k);
    let ends = |k: usize| matches!(tokens.word(k), ")" | "{" | ";" | ",") || is_pair(k);
    let begins =
        |k: usize| matches!(tokens.word(k), "(" | "=" | "return" | "if" | "while" | ",") || k > 0 && is_pair(k - 1);
    if i > 1 && is_pair(i - 2) && ends(i + 1) {
        // The literal follows the operator. `a && false` is kept, because `a` may have side effects.
        let changes_nothing = (tokens.word(i - 1) == "&") == value;
        return changes_nothing.then(|| (i - 2..i + 1, Vec::new()));
    }
    if is_pair(i + 1) && i > 0 && begins(i - 1) {
        let changes_nothing = (tokens.word(i + 1) == "&") == value;
        if !changes_nothing {
            return Some((i + 1..operands_end(tokens, i + 3, tokens.word(i + 1)), Vec::new()));
        }
        let mut next = tokens.0.get(i + 3)?.clone();
        next.gap.clone_from(&tokens.0[i].gap);
        return Some((i..i + 4, vec![next]));
    }
    chosen(tokens, i, value)
}

/// Returns the end of the operands that the operator `sign` joins from token `from` on.
fn operands_end(tokens: &Tokens, from: usize, sign: &str) -> usize {
    let mut k = from;
    while k < tokens.len() {
        match tokens.word(k) {
            "(" | "[" => k = tokens.closing(k).unwrap_or(k),
            ")" | "{" | ";" | "," => return k,
            "|" if sign == "&" && tokens.word(k + 1) == "|" => return k,
            _ => {}
        }
        k += 1;
    }
    k
}

/// Simplifies `select(a, b, LITERAL)` with the literal at token `i`.
fn chosen<'a>(tokens: &Tokens<'a>, i: usize, value: bool) -> Option<Splice<'a>> {
    if tokens.before(i) != "," || tokens.word(i + 1) != ")" {
        return None;
    }
    let open = (0..i).rev().find(|&k| tokens.word(k) == "(" && tokens.closing(k) == Some(i + 1))?;
    let [a, b, _] = &tokens.split(open + 1..i + 1)[..] else { return None };
    let (kept, lost) = if value { (b, a) } else { (a, b) };
    if tokens.before(open) != "select" || has_call(&tokens.0[lost.clone()]) || is_number(&tokens.0[kept.clone()]) {
        return None;
    }
    let mut new = grouped(&tokens.0[kept.clone()]);
    new[0].gap.clone_from(&tokens.0[open - 1].gap);
    Some((open - 1..i + 2, new))
}
