//! Writes images on another thread, so that the device need not wait for their compression.

use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread::JoinHandle;

use super::{ImageWriter, OutputError};
use crate::render::Band;

/// The files of one image, which receive the same bands.
///
/// The host stores up to three bands: one that is rendered, one that waits, and one that is written. Files that are dropped before
/// [`finish`](Self::finish) leave existing ones unchanged.
#[derive(Debug)]
pub struct BackgroundWriter {
    /// The bands; `None` completes the files.
    bands: Option<SyncSender<Option<Band>>>,
    thread: Option<JoinHandle<Result<(), OutputError>>>,
}

impl BackgroundWriter {
    /// Starts a thread that writes the bands of an image.
    #[must_use]
    pub fn new(mut writers: Vec<Box<dyn ImageWriter>>) -> Self {
        let (sender, bands) = sync_channel::<Option<Band>>(1);
        let thread = std::thread::spawn(move || {
            for band in bands {
                let Some(band) = band else { return writers.into_iter().try_for_each(ImageWriter::finish) };
                writers.iter_mut().try_for_each(|writer| writer.write_band(&band))?;
            }
            Ok(())
        });
        Self { bands: Some(sender), thread: Some(thread) }
    }

    /// Passes on a band, which must begin at the row after the last one.
    ///
    /// # Errors
    ///
    /// Returns the error of an earlier band; see [`ImageWriter::write_band`].
    pub fn write_band(&mut self, band: Band) -> Result<(), OutputError> {
        self.send(Some(band))
    }

    /// Lets the thread complete the files after the bands that it has received.
    ///
    /// # Errors
    ///
    /// Returns the error of an earlier band; see [`ImageWriter::write_band`].
    pub fn complete(&mut self) -> Result<(), OutputError> {
        self.send(None)
    }

    /// Waits until the files are complete.
    ///
    /// # Errors
    ///
    /// Returns the error of a band, or of [`ImageWriter::finish`].
    pub fn finish(mut self) -> Result<(), OutputError> {
        self.bands = None;
        self.join()
    }

    fn send(&mut self, band: Option<Band>) -> Result<(), OutputError> {
        match &self.bands {
            Some(bands) if bands.send(band).is_ok() => Ok(()),
            // The thread has ended with an error.
            _ => self.join(),
        }
    }

    fn join(&mut self) -> Result<(), OutputError> {
        let ended = self.thread.take().map_or(Ok(Ok(())), JoinHandle::join);
        ended.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    }
}

impl Drop for BackgroundWriter {
    /// Waits for the thread, whose files an early end leaves unfinished.
    fn drop(&mut self) {
        self.bands = None;
        let _ = self.thread.take().map(JoinHandle::join);
    }
}
