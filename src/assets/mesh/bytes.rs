//! Shared code of binary formats: values read from bytes, and errors at a byte offset.

use super::text::LARGEST;
use crate::assets::format_error::FormatError;

/// A reader of bytes that takes values one after the other.
pub(super) struct Bytes<'a> {
    all: &'a [u8],
    /// The number of bytes taken so far.
    pub at: usize,
}

impl<'a> Bytes<'a> {
    pub fn from(all: &'a [u8], at: usize) -> Self {
        Self { all, at }
    }

    /// Returns the number of bytes that are left.
    pub fn left(&self) -> usize {
        self.all.len().saturating_sub(self.at)
    }

    /// Returns the bytes that have not been taken yet.
    pub fn rest(&self) -> &'a [u8] {
        self.all.get(self.at..).unwrap_or_default()
    }

    /// Takes the next `N` bytes.
    pub fn take<const N: usize>(&mut self) -> Result<[u8; N], FormatError> {
        let mut bytes = [0; N];
        bytes.copy_from_slice(self.take_some(N)?);
        Ok(bytes)
    }

    /// Takes the next `count` bytes.
    pub fn take_some(&mut self, count: usize) -> Result<&'a [u8], FormatError> {
        let short = || FormatError::at(self.at, &format!("unexpected end of file, expected {count} more bytes"));
        let bytes = self.rest().get(..count).ok_or_else(short)?;
        self.at += count;
        Ok(bytes)
    }
}

/// Returns `true` for a coordinate that can be used: finite, and not too large.
pub(super) fn usable(value: impl Into<f64>) -> bool {
    (value.into() as f32).abs() <= LARGEST
}
