//! A reader of an image part from an EXR that [`exr`](super::exr) wrote, row by row from the top.
//!
//! The file is open from its first row to its last only, so that an image may have more parts than a process may open files. Host memory:
//! one block of sixteen rows.

use std::{
    fs::File,
    io::BufReader,
    path::{Path, PathBuf},
};

use ::exr::{
    block::{
        self,
        reader::{AllChunksReader, ChunksReader, SequentialBlockDecompressor},
    },
    error::Error as ExrError,
    meta::{
        BlockDescription,
        attribute::{AttributeValue, IntegerBounds, LineOrder},
        header::Header,
    },
};

use super::band::channels as channels_of;
use super::exr::{header as header_of, row_bytes};
use super::origin::{SHOWN, with_shown};
use super::{FileSettings, OutputError};
use crate::assets::unlikely_exr;
use crate::program::Layer;
use crate::render::Window;

type Blocks = SequentialBlockDecompressor<AllChunksReader<BufReader<File>>>;

/// An EXR with a part of an image, or all of it.
pub struct ImagePart {
    pub path: PathBuf,
    /// The settings with which it was written.
    pub settings: FileSettings,
    /// The number of bytes of one of its rows.
    pub row_bytes: usize,
    reading: Option<Reading>,
}

/// An open file.
struct Reading {
    blocks: Blocks,
    /// The rows of the current block; `used` bytes have been read.
    data: Vec<u8>,
    used: usize,
    /// The first row of the next block, from the top of the part.
    next: usize,
}

impl ImagePart {
    /// Opens a file and reads its metadata.
    pub fn open(path: &Path) -> Result<Self, OutputError> {
        let wrong = |problem: String| OutputError::Part { path: path.to_owned(), problem };
        let reader = reader(path)?;
        let [header] = reader.headers() else {
            return Err(wrong("it has several layers; only images written by `render` can be merged".into()));
        };
        let bytes = std::fs::metadata(path).map_err(|cause| OutputError::Read { path: path.to_owned(), cause })?.len();
        if let Some(problem) = unlikely_exr(header, bytes) {
            return Err(wrong(problem));
        }
        let settings = settings(header).filter(|settings| {
            let own = header_of(settings);
            own.channels == header.channels
                && header.blocks == BlockDescription::ScanLines
                && header.line_order == LineOrder::Increasing
        });
        let settings = settings.ok_or_else(|| {
            wrong("this image was not written by `render`, and only such images can be merged".into())
        })?;
        if !settings.window.fits(settings.size) {
            return Err(wrong(format!("the window {} is not inside its image", settings.window)));
        }
        Ok(Self { path: path.to_owned(), settings, row_bytes: row_bytes(header), reading: None })
    }

    /// Returns the next row: its samples by channel name.
    pub fn next_row(&mut self) -> Result<&[u8], OutputError> {
        let path = &self.path;
        if self.reading.is_none() {
            let chunks = reader(path)?.all_chunks(false).map_err(|error| failed(path, error))?;
            let blocks = chunks.sequential_decompressor(false);
            self.reading = Some(Reading { blocks, data: Vec::new(), used: 0, next: 0 });
        }
        let cut_short = || OutputError::Part { path: path.clone(), problem: "the file is truncated".into() };
        let reading = self.reading.as_mut().ok_or_else(cut_short)?;
        if reading.used == reading.data.len() {
            let block = reading.blocks.decompress_next_block().ok_or_else(cut_short)?;
            let block = block.map_err(|error| failed(path, error))?;
            if block.index.pixel_position.1 != reading.next {
                return Err(OutputError::Part { path: path.clone(), problem: "its rows are not in order".into() });
            }
            reading.next += block.index.pixel_size.1;
            (reading.data, reading.used) = (block.data, 0);
        }
        let start = reading.used;
        reading.used += self.row_bytes;
        Ok(&reading.data[start..reading.used])
    }

    /// Closes the file after all rows have been read.
    pub fn close(&mut self) {
        self.reading = None;
    }
}

/// Returns the metadata of the EXR at `path` under `key`.
pub fn said_by_exr(path: &Path, key: &str) -> Result<Option<String>, OutputError> {
    let reader = reader(path)?;
    Ok(reader.headers().iter().find_map(|header| match header.own_attributes.other.get(key.as_bytes()) {
        Some(AttributeValue::Text(text)) => utf8(text.as_slice()),
        _ => None,
    }))
}

fn reader(path: &Path) -> Result<block::reader::Reader<BufReader<File>>, OutputError> {
    let file = File::open(path).map_err(|cause| OutputError::Read { path: path.to_owned(), cause })?;
    block::read(BufReader::new(file), false).map_err(|error| failed(path, error))
}

/// Returns the settings with which a file was written, or `None` if this program did not write it.
fn settings(header: &Header) -> Option<FileSettings> {
    let IntegerBounds { position, size } = header.shared_attributes.display_window;
    let at = header.own_attributes.layer_position;
    let whole = |size: ::exr::math::Vec2<usize>| Some([u32::try_from(size.0).ok()?, u32::try_from(size.1).ok()?]);
    let origin = [u32::try_from(at.0).ok()?, u32::try_from(at.1).ok()?];
    let has = |name: &&str| header.channels.list.iter().any(|channel| channel.name.eq(name));
    let mut metadata: Vec<(String, String)> = Vec::new();
    for (key, value) in &header.own_attributes.other {
        let AttributeValue::Text(text) = value else { return None };
        metadata.push((utf8(key.as_slice())?, utf8(text.as_slice())?));
    }
    metadata.sort();
    let (shown, metadata): (Vec<_>, _) = metadata.into_iter().partition(|(key, _)| key == SHOWN);
    (position.0 == 0 && position.1 == 0).then_some(())?;
    let settings = FileSettings {
        window: Window { origin, size: whole(header.layer_size)? },
        alpha: has(&"A"),
        layers: Layer::ALL.into_iter().filter(|layer| channels_of(*layer).iter().all(has)).collect(),
        metadata,
        ..FileSettings::new(whole(size)?)
    };
    match shown.first() {
        Some((_, text)) => with_shown(settings, text),
        None => Some(settings),
    }
}

fn utf8(bytes: &[u8]) -> Option<String> {
    String::from_utf8(bytes.to_vec()).ok()
}

fn failed(path: &Path, error: ExrError) -> OutputError {
    let path = path.to_owned();
    match error {
        ExrError::Io(cause) => OutputError::Read { path, cause },
        other => OutputError::Part { path, problem: format!("this is not a complete EXR: {other}") },
    }
}
