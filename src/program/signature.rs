//! Signatures of functions.

use std::ops::Range;

use super::tokens::Tokens;

/// The parameters and the result of a function, as tokens.
#[derive(Debug)]
pub(super) struct Signature {
    pub(super) parameters: Vec<Parameter>,
    /// The type of the result, without attributes.
    pub(super) result: Option<Range<usize>>,
    /// The brace that opens its body.
    pub(super) body: usize,
}

#[derive(Debug)]
pub(super) struct Parameter {
    pub(super) name: usize,
    pub(super) ty: Range<usize>,
}

impl Signature {
    /// Returns the signature of the function whose keyword is the token `head`.
    pub(super) fn of(tokens: &Tokens, head: usize) -> Option<Self> {
        if tokens.word(head) != "fn" || tokens.word(head + 2) != "(" {
            return None;
        }
        let end = tokens.closing(head + 2)?;
        let parameters = tokens.split(head + 3..end).into_iter().map(|piece| {
            let name = tokens.behind_attributes(piece.start);
            Parameter { name, ty: piece.end.min(name + 2)..piece.end }
        });
        let parameters = parameters.collect();
        let body = (end..tokens.len()).find(|&i| tokens.word(i) == "{")?;
        let has_result = tokens.word(end + 1) == "-" && tokens.word(end + 2) == ">";
        let result = has_result.then(|| tokens.behind_attributes(end + 3)..body);
        Some(Self { parameters, result, body })
    }
}
