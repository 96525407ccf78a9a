//! The merge of separately rendered parts of an image into the file that a single render would have written, byte for byte.
//!
//! The windows of the parts must cover the image, and overlapping windows must have identical bits. The parts and the output are processed
//! from the top, so that the host stores some rows of the output and one block of each part that crosses them.

use std::path::{Path, PathBuf};

use super::band::channel_names;
use super::exr::ExrWriter;
use super::origin::{SHOWN, difference, shown_words};
use super::part::ImagePart;
use super::whole::band_of;
use super::{FileSettings, ImageWriter, OutputError, has_extension, open, stores_layers};
use crate::render::Window;

/// The number of rows written at once: enough blocks for all cores.
const ROWS: usize = 64;
/// The size of a sample, which is a 32-bit float or an id.
const SAMPLE_BYTES: usize = 4;

/// Merges the EXRs at `parts` into each of `outputs`, as a render of the whole image would have written it.
///
/// # Errors
///
/// Returns [`OutputError::Part`] if a part is not from `render`, the parts have different settings, leave a gap or disagree on a pixel; and
/// an error if a file cannot be read or written.
pub fn merge(parts: &[PathBuf], outputs: &[PathBuf]) -> Result<(), OutputError> {
    let mut parts = parts.iter().map(|path| ImagePart::open(path)).collect::<Result<Vec<_>, _>>()?;
    let Some(first) = parts.first() else { return Ok(()) };
    parts.iter().try_for_each(|part| alike(first, part))?;
    let size = first.settings.size;
    let settings = FileSettings { window: Window::whole(size), ..first.settings.clone() };
    let mut wholes = outputs.iter().map(|path| Whole::create(path, &settings)).collect::<Result<Vec<_>, _>>()?;
    let windows: Vec<Window> = parts.iter().map(|part| part.settings.window).collect();
    if let Some(gap) = gap(&windows, size) {
        let [[left, top], [width, height]] = [gap.origin, gap.size];
        let problem = format!(
            "the parts leave a gap at column {left}, row {top}: render it with --crop {left},{top},{width}x{height}"
        );
        return Err(OutputError::Part { path: outputs.first().cloned().unwrap_or_default(), problem });
    }
    let samples = first.row_bytes / SAMPLE_BYTES / windows[0].size[0] as usize;
    let row_bytes = SAMPLE_BYTES * samples * size[0] as usize;
    let mut rows = Vec::new();
    for y in 0..size[1] {
        let mut row = Row { bytes: vec![0; row_bytes], owners: vec![None; size[0] as usize], samples };
        for i in 0..parts.len() {
            let Window { origin: [left, top], size: [_, height] } = windows[i];
            if !(top..top + height).contains(&y) {
                continue;
            }
            if let Err((other, x)) = row.put(i, left as usize, parts[i].next_row()?) {
                let [this, other] = [i, other].map(|k| parts[k].path.display());
                let problem = format!(
                    "{this} and {other} disagree at column {x}, row {y}: render both again from the same scene with \
                     the same method"
                );
                return Err(OutputError::Part { path: outputs.first().cloned().unwrap_or_default(), problem });
            }
            if y + 1 == top + height {
                parts[i].close();
            }
        }
        rows.extend(row.bytes);
        if rows.len() == ROWS * row_bytes || y + 1 == size[1] {
            let first_row = y + 1 - (rows.len() / row_bytes) as u32;
            wholes.iter_mut().try_for_each(|whole| whole.write_rows(first_row, &rows))?;
            rows.clear();
        }
    }
    wholes.into_iter().try_for_each(Whole::finish)
}

/// An unfinished file of the whole image.
enum Whole {
    Exr(Box<ExrWriter>),
    /// A writer of another format, with the settings of the parts.
    Other(Box<dyn ImageWriter>, FileSettings),
}

impl Whole {
    fn create(path: &Path, settings: &FileSettings) -> Result<Self, OutputError> {
        if has_extension(path, "exr") {
            return Ok(Self::Exr(Box::new(ExrWriter::create(path, settings)?)));
        }
        let layers = if stores_layers(path) { settings.layers.clone() } else { Vec::new() };
        let writer = open(path, &FileSettings { layers, ..settings.clone() })?;
        Ok(Self::Other(writer, settings.clone()))
    }

    fn write_rows(&mut self, first_row: u32, bytes: &[u8]) -> Result<(), OutputError> {
        let (writer, settings) = match self {
            Self::Exr(writer) => return writer.write_rows(bytes),
            Self::Other(writer, settings) => (writer, settings),
        };
        let width = settings.size[0] as usize;
        let names = channel_names(settings);
        let row_bytes = SAMPLE_BYTES * names.len() * width;
        let plane = |place: usize| -> Vec<u32> {
            let of_row = |row: &[u8]| -> Vec<u32> {
                bytemuck::pod_collect_to_vec(&row[SAMPLE_BYTES * place * width..SAMPLE_BYTES * (place + 1) * width])
            };
            bytes.chunks_exact(row_bytes).flat_map(of_row).collect()
        };
        let planes = names.iter().enumerate().map(|(place, name)| (*name, plane(place))).collect();
        let rows = (bytes.len() / row_bytes) as u32;
        writer.write_band(&band_of(settings, planes, [first_row, rows]))
    }

    fn finish(self) -> Result<(), OutputError> {
        match self {
            Self::Exr(writer) => writer.finish(),
            Self::Other(writer, _) => writer.finish(),
        }
    }
}

/// Checks that a part belongs to the same image as the first.
fn alike(first: &ImagePart, part: &ImagePart) -> Result<(), OutputError> {
    let (whole, own) = (&first.settings, &part.settings);
    let other = first.path.display();
    let differ = |problem: String| Err(OutputError::Part { path: part.path.clone(), problem });
    if whole.size != own.size {
        let [this, that] = [own, whole].map(|settings| format!("{}x{}", settings.size[0], settings.size[1]));
        return differ(format!(
            "this is a part of an image of {this} pixels, but {other} is a part of an image of {that}"
        ));
    }
    if (whole.alpha, &whole.layers) != (own.alpha, &own.layers) {
        return differ(format!("its layers differ from those of {other}; render all parts with the same --layers"));
    }
    let shown = [own, whole].map(|settings| vec![(SHOWN.to_owned(), shown_words(settings))]);
    let found = difference([&own.metadata, &whole.metadata], &[]);
    let Some(found) = found.or_else(|| difference([&shown[0], &shown[1]], &[])) else { return Ok(()) };
    let (key, [this, that]) = (&found.key, [0, 1].map(|which| found.value(which)));
    differ(format!("its `{key}` is {this}, but that of {other} is {that}; render all parts with the same settings"))
}

/// Returns a region of the image that no window covers, if there is one.
fn gap(windows: &[Window], [width, height]: [u32; 2]) -> Option<Window> {
    let mut edges: Vec<u32> = windows.iter().flat_map(|w| [w.origin[1], w.origin[1] + w.size[1]]).collect();
    edges.extend([0, height]);
    edges.sort_unstable();
    edges.dedup();
    edges.windows(2).find_map(|rows| {
        let [top, bottom] = [rows[0], rows[1]];
        let crosses = |w: &&Window| w.origin[1] <= top && bottom <= w.origin[1] + w.size[1];
        let spans = windows.iter().filter(crosses).map(|w| [w.origin[0], w.origin[0] + w.size[0]]);
        let mut spans: Vec<_> = spans.chain([[width, width]]).collect();
        spans.sort_unstable();
        let mut covered = 0;
        for [left, right] in spans {
            if left > covered {
                return Some(Window { origin: [covered, top], size: [left - covered, bottom - top] });
            }
            covered = covered.max(right);
        }
        None
    })
}

/// An unfinished row of the output.
struct Row {
    /// The samples by channel.
    bytes: Vec<u8>,
    /// The first part that supplied each pixel.
    owners: Vec<Option<usize>>,
    /// The number of channels.
    samples: usize,
}

impl Row {
    /// Writes a part's row from column `left`. If its bits differ from those of another part, returns that part and the column.
    fn put(&mut self, part: usize, left: usize, row: &[u8]) -> Result<(), (usize, usize)> {
        let [width, own] = [self.owners.len(), row.len() / SAMPLE_BYTES / self.samples];
        let mut from = 0;
        while from < own {
            let owners = &mut self.owners[left + from..left + own];
            let owner = owners[0];
            let run = owners.iter().take_while(|other| **other == owner).count();
            owners[..run].fill(owner.or(Some(part)));
            for channel in 0..self.samples {
                let start = SAMPLE_BYTES * (channel * width + left + from);
                let there = &mut self.bytes[start..start + SAMPLE_BYTES * run];
                let start = SAMPLE_BYTES * (channel * own + from);
                let here = &row[start..start + SAMPLE_BYTES * run];
                match owner {
                    None => there.copy_from_slice(here),
                    Some(other) => {
                        if let Some(byte) = there.iter().zip(here).position(|(a, b)| a != b) {
                            return Err((other, left + from + byte / SAMPLE_BYTES));
                        }
                    }
                }
            }
            from += run;
        }
        Ok(())
    }
}
