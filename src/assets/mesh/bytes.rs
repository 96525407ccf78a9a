//! What binary formats share: values taken from bytes, and what is wrong with the bytes at a place.

use std::path::Path;

use super::text::LARGEST;
use crate::document::SceneError;

/// Bytes that values are taken from, one after the other.
pub(super) struct Bytes<'a> {
    all: &'a [u8],
    /// How many were taken.
    pub at: usize,
}

/// What is wrong with a file that has no lines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::assets) struct Flaw(pub String);

impl Flaw {
    /// At a byte, counted from 0.
    pub fn at(byte: usize, problem: &str) -> Self {
        Self(format!("at byte {byte}: {problem}"))
    }

    pub fn of(self, path: &Path) -> SceneError {
        SceneError::Mesh { path: path.to_owned(), problem: self.0 }
    }
}

impl<'a> Bytes<'a> {
    pub fn from(all: &'a [u8], at: usize) -> Self {
        Self { all, at }
    }

    /// How many there are still.
    pub fn left(&self) -> usize {
        self.all.len().saturating_sub(self.at)
    }

    /// The next `N`.
    pub fn take<const N: usize>(&mut self) -> Result<[u8; N], Flaw> {
        match self.all.get(self.at..).and_then(|rest| rest.first_chunk()) {
            Some(bytes) => {
                self.at += N;
                Ok(*bytes)
            }
            None => Err(Flaw::at(self.at, &format!("the file ends; {N} more bytes were expected"))),
        }
    }
}

/// A coordinate that can be used: finite, and not too large.
pub(super) fn usable(value: f32) -> bool {
    value.abs() <= LARGEST
}
