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
        self.send(None)?;
        self.bands = None;
        Ok(())
    }

    /// Completes the files, if [`complete`](Self::complete) has not, and waits until they are written.
    ///
    /// # Errors
    ///
    /// Returns the error of a band, or of [`ImageWriter::finish`].
    pub fn finish(mut self) -> Result<(), OutputError> {
        if self.bands.is_some() {
            self.complete()?;
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::{FileSettings, open};

    fn band(first_row: u32) -> Band {
        let color = [0.1, 0.4, 0.9].map(|value| vec![value * (1 + first_row) as f32; 3]);
        Band { first_row, rows: 1, width: 3, color, alpha: None, layers: Vec::new() }
    }

    #[test]
    fn files_are_those_that_are_written_directly() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a.png", "a.exr"] {
            let [here, there] = ["here", "there"].map(|part| folder.path().join(format!("{part}_{name}")));
            let settings = FileSettings::new([3, 4]);
            let mut direct = open(&here, &settings).unwrap();
            let mut background = BackgroundWriter::new(vec![open(&there, &settings).unwrap()]);
            for row in 0..4 {
                direct.write_band(&band(row)).unwrap();
                background.write_band(band(row)).unwrap();
            }
            direct.finish().unwrap();
            background.finish().unwrap();
            assert_eq!(std::fs::read(&here).unwrap(), std::fs::read(&there).unwrap(), "{name}");
        }
    }

    #[test]
    fn an_error_of_a_band_is_returned() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        let mut writer = BackgroundWriter::new(vec![open(&path, &FileSettings::new([3, 4])).unwrap()]);
        // The thread may receive the error while other bands wait.
        let sent = (1..50).map(|row| writer.write_band(band(row))).find(Result::is_err);
        assert!(matches!(sent, Some(Err(OutputError::Band { row: 1, .. }))), "{sent:?}");
        assert!(!path.exists());
    }

    #[test]
    fn files_that_are_not_completed_do_not_replace_others() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        std::fs::write(&path, "earlier").unwrap();
        let mut writer = BackgroundWriter::new(vec![open(&path, &FileSettings::new([3, 1])).unwrap()]);
        writer.write_band(band(0)).unwrap();
        drop(writer);
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "earlier");
    }
}
