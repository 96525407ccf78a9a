//! What binary formats share: values taken from bytes, and what is wrong with the bytes at a place.

use super::text::LARGEST;
use crate::assets::flaw::Flaw;

/// Bytes that values are taken from, one after the other.
pub(super) struct Bytes<'a> {
    all: &'a [u8],
    /// How many were taken.
    pub at: usize,
}

impl<'a> Bytes<'a> {
    pub fn from(all: &'a [u8], at: usize) -> Self {
        Self { all, at }
    }

    /// How many there are still.
    pub fn left(&self) -> usize {
        self.all.len().saturating_sub(self.at)
    }

    /// Returns the bytes that are not taken yet.
    pub fn rest(&self) -> &'a [u8] {
        self.all.get(self.at..).unwrap_or_default()
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

/// Returns `true` for a coordinate that can be used: finite, and not too large.
pub(super) fn usable(value: impl Into<f64>) -> bool {
    (value.into() as f32).abs() <= LARGEST
}
