//! The EXR writer, which stores every plane exactly in a single-part scanline file for further processing.
//!
//! Rows are compressed losslessly in blocks of sixteen (ZIP), on all cores, in order of arrival. The writers of the `exr` crate own the
//! loop over blocks, so this one composes the file from the crate's public parts: the header, a table of block offsets (filled in at the
//! end), and the blocks. These it compresses itself, because the crate's compressor takes twice as long. Attributes are sorted by name,
//! because the crate stores them in an unordered map. Host memory: one band as bytes, and its compressed blocks.
//!
//! Channels: `R`, `G`, `B`, `A` if the image has alpha (the colors are premultiplied), and those of [`channels`](super::band::channels).
//! Floats have 32 bits, ids are unsigned integers.

use std::{
    io::{self, Seek, SeekFrom, Write},
    path::Path,
};

use ::exr::{
    block::chunk::{Chunk, CompressedBlock, CompressedScanLineBlock},
    error::Error as ExrError,
    math::Vec2,
    meta::{
        BlockDescription, MetaData,
        attribute::{self, AttributeValue, ChannelDescription, LineOrder, SampleType, Text},
        header::{Header, ImageAttributes, LayerAttributes},
        magic_number, sequence_end,
    },
    prelude::{Compression, SmallVec},
};
use flate2::write::ZlibEncoder;
use rayon::prelude::*;

use super::band::{Rows, channels as channels_of, components};
use super::origin::{SHOWN, shown_words};
use super::{AtomicFile, FileSettings, ImageWriter, OutputError};
use crate::program::{Layer, LayerKind};
use crate::render::Band;

/// The number of rows per block of ZIP compression.
const BLOCK_ROWS: usize = 16;
/// The level of compression: the next ones take longer and save less than a percent.
const LEVEL: u32 = 2;

/// A writer of an EXR.
pub struct ExrWriter {
    rows: Rows,
    header: Header,
    file: AtomicFile,
    table_at: u64,
    /// The offset of each written block in the file.
    offsets: Vec<u64>,
    /// The rows not yet in a block: samples by row and by channel name.
    pending: Vec<u8>,
}

impl ExrWriter {
    /// Starts an EXR at `path`; exposure, tone map and bit depth are not used.
    ///
    /// # Errors
    ///
    /// Returns an error if the file cannot be created ([`AtomicFile::create`]) or the head of the file cannot be written.
    pub fn create(path: &Path, settings: &FileSettings) -> Result<Self, OutputError> {
        let layers = sorted_layers(settings);
        let rows = Rows::new(path.to_owned(), settings.window.size, settings.alpha, layers);
        let header = header(settings);
        let mut file = AtomicFile::create(path)?;
        let table_at = write_head(&header, &mut file).map_err(|e| encode_error(&file, e))?;
        Ok(Self { rows, header, file, table_at, offsets: Vec::new(), pending: Vec::new() })
    }

    fn row_bytes(&self) -> usize {
        row_bytes(&self.header)
    }

    /// Appends whole rows in the layout of a block: samples by row and by channel name.
    pub(super) fn write_rows(&mut self, bytes: &[u8]) -> Result<(), OutputError> {
        self.rows.count((bytes.len() / self.row_bytes()) as u32);
        self.pending.extend(bytes);
        self.write_blocks().map_err(|e| encode_error(&self.file, e))
    }

    /// Appends the rows of a band to the pending ones.
    fn gather(&mut self, band: &Band) {
        let mut channels: Vec<(&str, &[u8])> =
            ["R", "G", "B"].into_iter().zip(band.color.iter().map(|c| bytemuck::cast_slice(c))).collect();
        if let (true, Some(alpha)) = (self.rows.alpha, &band.alpha) {
            channels.push(("A", bytemuck::cast_slice(alpha)));
        }
        for &layer in &self.rows.layers {
            let planes = band.layer(layer).map_or_else(Vec::new, components);
            channels.extend(channels_of(layer).iter().copied().zip(planes));
        }
        channels.sort_unstable_by_key(|(name, _)| *name);
        let bytes = band.width as usize * size_of::<f32>();
        for y in 0..band.rows as usize {
            for (_, plane) in &channels {
                self.pending.extend(&plane[y * bytes..(y + 1) * bytes]);
            }
        }
    }

    /// Compresses and writes the complete pending blocks, or all of them at the end.
    fn write_blocks(&mut self) -> Result<(), ExrError> {
        let block_bytes = BLOCK_ROWS * self.row_bytes();
        let ready =
            if self.rows.is_complete() { self.pending.len() } else { self.pending.len() / block_bytes * block_bytes };
        let first = self.offsets.len();
        for chunk in compress_all(&self.header, first, &self.pending[..ready])? {
            self.offsets.push(self.file.stream_position()?);
            chunk.write(&mut self.file, 1)?;
        }
        self.pending.drain(..ready);
        Ok(())
    }
}

impl ImageWriter for ExrWriter {
    fn write_band(&mut self, band: &Band) -> Result<(), OutputError> {
        self.rows.accept(band)?;
        self.gather(band);
        self.write_blocks().map_err(|e| encode_error(&self.file, e))
    }

    fn finish(self: Box<Self>) -> Result<(), OutputError> {
        let mut this = *self;
        this.rows.complete()?;
        let table: Vec<u8> = this.offsets.iter().flat_map(|o| o.to_le_bytes()).collect();
        this.file
            .seek(SeekFrom::Start(this.table_at))
            .and_then(|_| this.file.write_all(&table))
            .map_err(|e| this.file.failed(e))?;
        this.file.finish()
    }
}

/// Returns the number of bytes of a row; every sample has four.
pub(super) fn row_bytes(header: &Header) -> usize {
    header.layer_size.0 * header.channels.bytes_per_pixel
}

/// Compresses rows of complete blocks on all cores; the first is block `first` of the image.
fn compress_all(header: &Header, first: usize, bytes: &[u8]) -> Result<Vec<Chunk>, ExrError> {
    let row_bytes = row_bytes(header);
    let blocks: Vec<(usize, &[u8])> = (first..).zip(bytes.chunks(BLOCK_ROWS * row_bytes)).collect();
    blocks.par_iter().map(|(index, data)| compress(header, *index, data).map_err(ExrError::Io)).collect()
}

/// Compresses a block: the first and third bytes of its samples, then the others, each as its difference from the previous one. A block that
/// does not become smaller is stored as it is.
fn compress(header: &Header, index: usize, data: &[u8]) -> io::Result<Chunk> {
    let samples: Vec<u8> = data.chunks_exact(4).flat_map(little_endian).collect();
    let halves = [0, 1].into_iter().flat_map(|start| samples.iter().skip(start).step_by(2));
    let mut last = 128;
    let differences: Vec<u8> =
        halves.map(|byte| byte.wrapping_sub(std::mem::replace(&mut last, *byte)).wrapping_add(128)).collect();
    let mut encoder = ZlibEncoder::new(Vec::new(), flate2::Compression::new(LEVEL));
    encoder.write_all(&differences)?;
    let compressed = encoder.finish()?;
    let compressed_pixels_le = if compressed.len() < samples.len() { compressed } else { samples };
    let y_coordinate = header.own_attributes.layer_position.1 + ((index * BLOCK_ROWS) as u32).cast_signed();
    let compressed_block = CompressedBlock::ScanLine(CompressedScanLineBlock { y_coordinate, compressed_pixels_le });
    Ok(Chunk { layer_index: 0, compressed_block })
}

/// Returns the bytes of a sample in the order of the file.
fn little_endian(sample: &[u8]) -> [u8; 4] {
    sample.try_into().map_or([0; 4], |bytes| u32::from_ne_bytes(bytes).to_le_bytes())
}

/// Returns the header of a file with these settings.
pub(super) fn header(settings: &FileSettings) -> Header {
    let size = |[width, height]: [u32; 2]| Vec2(width as usize, height as usize);
    let mut names: Vec<(&str, SampleType)> = ["R", "G", "B"].map(|c| (c, SampleType::F32)).into();
    if settings.alpha {
        names.push(("A", SampleType::F32));
    }
    for layer in sorted_layers(settings) {
        let kind = if layer.kind() == LayerKind::Id { SampleType::U32 } else { SampleType::F32 };
        names.extend(channels_of(layer).iter().map(|name| (*name, kind)));
    }
    names.sort_unstable_by_key(|(name, _)| *name);
    let channels: SmallVec<_> =
        names.into_iter().map(|(name, kind)| ChannelDescription::new(name, kind, false)).collect();
    let said = settings.metadata.iter().map(|(key, text)| (key.as_str(), text.clone()));
    let said = said.chain([(SHOWN, shown_words(settings))]);
    let other = said.map(|(key, text)| (utf8(key), AttributeValue::Text(utf8(&text)))).collect();
    let [left, top] = settings.window.origin.map(u32::cast_signed);
    Header::new(Text::from(""), size(settings.window.size), channels)
        .with_encoding(Compression::ZIP16, BlockDescription::ScanLines, LineOrder::Increasing)
        .with_attributes(LayerAttributes { layer_position: Vec2(left, top), ..LayerAttributes::default() })
        .with_shared_attributes(ImageAttributes { other, ..ImageAttributes::with_size(size(settings.size)) })
}

fn sorted_layers(settings: &FileSettings) -> Vec<Layer> {
    let mut layers = settings.layers.clone();
    layers.sort_unstable();
    layers.dedup();
    layers
}

/// Returns EXR text in UTF-8; the crate's constructor would convert it to Latin-1.
fn utf8(text: &str) -> Text {
    Text::from_slice_unchecked(text.as_bytes())
}

/// Writes the data before the blocks, and returns the offset of the block table, which stays empty.
fn write_head(header: &Header, file: &mut AtomicFile) -> Result<u64, ExrError> {
    let requirements = MetaData::validate(std::slice::from_ref(header), true)?;
    magic_number::write(file)?;
    requirements.write(file)?;
    let mut attributes: Vec<_> = header.all_named_attributes().collect();
    attributes.sort_unstable_by_key(|(name, _)| *name);
    for (name, value) in attributes {
        attribute::write(name, &value, file)?;
    }
    sequence_end::write(file)?;
    let table_at = file.stream_position()?;
    file.write_all(&vec![0; header.chunk_count * size_of::<u64>()])?;
    Ok(table_at)
}

fn encode_error(file: &AtomicFile, error: ExrError) -> OutputError {
    match error {
        ExrError::Io(cause) => file.failed(cause),
        other => OutputError::Encode { path: file.path().to_owned(), problem: other.to_string() },
    }
}
