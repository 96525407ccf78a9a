//! Errors of image decoders, in words for the owner of the file.

use std::error::Error;
use std::io::{self, ErrorKind};
use std::iter::successors;

/// Returns the error that a decoder found, as a message.
pub(super) fn broken(error: &(dyn Error + 'static)) -> String {
    // The messages of the decoders for a truncated file.
    const CUT: [&str; 3] = ["failed to fill whole buffer", "unexpected end of file", "reference to missing bytes"];
    let causes: Vec<_> = successors(Some(error), |error| (*error).source()).collect();
    let is_outside = |error: &&(dyn Error + 'static)| {
        error.downcast_ref::<io::Error>().is_some_and(|error| error.kind() == ErrorKind::InvalidInput)
    };
    let text = causes.last().map_or_else(String::new, ToString::to_string);
    if CUT.iter().any(|words| text.contains(words)) {
        "the file ends early".to_owned()
    } else if causes.iter().any(is_outside) {
        "the file is damaged: it refers to bytes outside of the file".to_owned()
    } else {
        let text = without_structs(text.trim_start_matches("invalid: "));
        // The name of an error in the decoder's code follows the first sentence.
        let first = text.split(". ").next().unwrap_or_default();
        format!("the file is damaged: {}", first.trim_end_matches('.'))
    }
}

/// Returns the text with each struct that represents a PNG chunk replaced by the chunk's name.
fn without_structs(text: &str) -> String {
    const BEGIN: &str = "ChunkType { type: ";
    let mut pieces = text.split(BEGIN);
    let mut plain = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (chunk, rest) = piece.split_once(" }").unwrap_or((piece, ""));
        plain += chunk.split(',').next().unwrap_or_default();
        plain += rest;
    }
    plain
}
