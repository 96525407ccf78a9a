//! Reports how much of a file has been read.

use std::io::{Read, Result, Seek, SeekFrom};

use super::Stage;

/// A reader that reports its position in bytes as the units of a stage.
#[derive(Debug)]
pub struct Watched<'s, R> {
    inner: R,
    stage: &'s Stage,
    at: u64,
}

impl<'s, R> Watched<'s, R> {
    /// Creates a reader that reports the position in `inner`, from its start, to `stage`.
    pub fn new(inner: R, stage: &'s Stage) -> Self {
        Self { inner, stage, at: 0 }
    }

    fn moved(&mut self, at: u64) {
        self.at = at;
        self.stage.reach(at as f64);
    }
}

impl<R: Read> Read for Watched<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let count = self.inner.read(buffer)?;
        self.moved(self.at + count as u64);
        Ok(count)
    }
}

impl<R: Seek> Seek for Watched<'_, R> {
    fn seek(&mut self, to: SeekFrom) -> Result<u64> {
        let at = self.inner.seek(to)?;
        self.moved(at);
        Ok(at)
    }
}
