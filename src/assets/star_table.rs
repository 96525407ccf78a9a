//! The table of a star catalog, in CSV.
//!
//! *Practice.* The first line that is not a comment names the columns, in the usual words of public catalogs; other columns are ignored.
//! Columns are separated by commas, semicolons or tabs. A color index B−V determines a temperature, T = 4600 K (1/(0.92 (B−V) + 1.7) +
//! 1/(0.92 (B−V) + 0.62)) (Ballesteros 2012).

use std::ops::{Range, RangeInclusive};
use std::path::Path;

use csv::{ByteRecord, Reader, ReaderBuilder};
use glam::DVec3;
use rayon::prelude::*;

use crate::document::{Diagnostic, SceneError};

/// A star of a catalog.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Star {
    /// The direction, with the north pole at +y, and right ascension 0 at −z, increasing towards −x.
    pub direction: DVec3,
    /// The visual magnitude.
    pub magnitude: f32,
    /// The temperature of a black body of the star's color, in kelvins; 0 in catalogs without colors.
    pub kelvins: f32,
}

/// The kinds of columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Column {
    Degrees,
    Hours,
    Declination,
    Magnitude,
    ColorIndex,
    Temperature,
}

/// The accepted names of columns, in lowercase.
const NAMES: [(&str, Column); 17] = [
    ("ra", Column::Degrees),
    ("ra_deg", Column::Degrees),
    ("raj2000", Column::Degrees),
    ("alpha", Column::Degrees),
    ("ra_h", Column::Hours),
    ("dec", Column::Declination),
    ("dec_deg", Column::Declination),
    ("dej2000", Column::Declination),
    ("mag", Column::Magnitude),
    ("vmag", Column::Magnitude),
    ("b_v", Column::ColorIndex),
    ("bv", Column::ColorIndex),
    ("b-v", Column::ColorIndex),
    ("ci", Column::ColorIndex),
    ("temperature", Column::Temperature),
    ("teff", Column::Temperature),
    ("kelvins", Column::Temperature),
];

/// The number of errors after which a file is not read further.
const ENOUGH: usize = 10;
/// The size of a part of a file that one thread reads, in bytes.
const PART: usize = 1 << 21;
/// The color index of a star whose color is unknown: that of the sun.
const USUAL_INDEX: f64 = 0.65;

/// The rows of a part of a file.
pub(super) struct Rows {
    pub(super) stars: Vec<Star>,
    /// `true` if every right ascension in degrees is at most 24.
    pub(super) may_be_hours: bool,
    /// The first mistakes.
    mistakes: Vec<Mistake>,
}

/// A mistake in a range of bytes. Its line is counted only if it is shown.
struct Mistake {
    place: Range<usize>,
    problem: String,
    help: String,
}

/// The values of a row by their [`Column`]; NaN if missing.
#[derive(Debug, Clone, Copy)]
struct Values([f64; 6]);

impl Values {
    /// Returns the value of a column, unless it is missing.
    fn of(&self, column: Column) -> Option<f64> {
        Some(self.0[column as usize]).filter(|value| !value.is_nan())
    }

    /// Returns the right ascension, in degrees.
    fn ascension(&self) -> f64 {
        self.of(Column::Degrees).or_else(|| Some(15.0 * self.of(Column::Hours)?)).unwrap_or_default()
    }
}

impl Column {
    /// Returns the values that the column accepts.
    fn range(self) -> (RangeInclusive<f64>, &'static str) {
        match self {
            Self::Degrees => (-360.0..=360.0, "a right ascension in degrees, from -360 to 360"),
            Self::Hours => (-24.0..=24.0, "a right ascension in hours, from -24 to 24"),
            Self::Declination => (-90.0..=90.0, "a declination in degrees, from -90 to 90"),
            Self::Magnitude => (-40.0..=40.0, "a magnitude from -40 to 40"),
            Self::ColorIndex => (-10.0..=20.0, "a color index from -10 to 20"),
            Self::Temperature => (1.0..=1e9, "a temperature in kelvins"),
        }
    }

    /// Returns `true` if a value may be missing.
    fn is_optional(self) -> bool {
        matches!(self, Self::ColorIndex | Self::Temperature)
    }
}

impl Star {
    /// Returns the star with these values.
    fn of(values: &Values, has_colors: bool) -> Self {
        let of = |column| values.of(column);
        let kelvins = of(Column::Temperature).or_else(|| has_colors.then(|| temperature(of(Column::ColorIndex))));
        Self {
            direction: direction(values.ascension(), of(Column::Declination).unwrap_or_default()),
            magnitude: of(Column::Magnitude).unwrap_or_default() as f32,
            kelvins: kelvins.unwrap_or_default() as f32,
        }
    }
}

/// Returns the direction of a star, from degrees. Right ascension increases to the left, as in maps of the sky seen from inside.
fn direction(ascension: f64, declination: f64) -> DVec3 {
    let ((sin_a, cos_a), (sin_d, cos_d)) = (ascension.to_radians().sin_cos(), declination.to_radians().sin_cos());
    DVec3::new(-cos_d * sin_a, sin_d, -cos_d * cos_a)
}

/// Returns the temperature of a color index B−V, in kelvins. The formula has a pole at −0.67, and is used where it was fitted.
pub(super) fn temperature(color_index: Option<f64>) -> f64 {
    let index = 0.92 * color_index.unwrap_or(USUAL_INDEX).clamp(-0.4, 4.0);
    4600.0 * (1.0 / (index + 1.7) + 1.0 / (index + 0.62))
}

/// A file, and the positions of its columns.
pub(super) struct StarTable<'t> {
    text: &'t str,
    path: &'t Path,
    separator: char,
    columns: Vec<(Column, usize)>,
    /// The byte after the header.
    body: usize,
}

impl<'t> StarTable<'t> {
    /// Reads the header of a file; `path` names it in errors.
    pub(super) fn new(text: &'t str, path: &'t Path) -> Result<Self, SceneError> {
        let head = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#')).unwrap_or_default();
        let separator = ['\t', ';', ','].into_iter().find(|&mark| head.contains(mark)).unwrap_or(',');
        let mut table = Self { text, path, separator, columns: Vec::new(), body: 0 };
        let mut reader = table.reader(text, true);
        let shown = |mistake: Mistake| SceneError::Diagnostics(vec![table.located(&mistake)]);
        let head = reader.byte_headers().map_err(|error| shown(table.unreadable(0, &error)))?;
        table.columns = table.columns(head).map_err(shown)?;
        table.body = reader.position().byte() as usize;
        Ok(table)
    }

    /// Reads the rows, in parallel. The parts do not depend on the number of threads.
    pub(super) fn read(&self) -> Result<Vec<Rows>, SceneError> {
        let read: Vec<Rows> = self.parts().into_par_iter().map(|part| self.rows(part)).collect();
        let mistakes = read.iter().flat_map(|rows| &rows.mistakes).take(ENOUGH);
        let mistakes: Vec<Diagnostic> = mistakes.map(|mistake| self.located(mistake)).collect();
        if mistakes.is_empty() { Ok(read) } else { Err(SceneError::Diagnostics(mistakes)) }
    }

    fn located(&self, Mistake { place, problem, help }: &Mistake) -> Diagnostic {
        Diagnostic::locate(self.path.to_owned(), self.text, place.start, place.end, problem.clone(), help.clone())
    }

    fn reader<'p>(&self, part: &'p str, has_headers: bool) -> Reader<&'p [u8]> {
        let mut reader = ReaderBuilder::new();
        reader.delimiter(self.separator as u8).comment(Some(b'#')).flexible(true).has_headers(has_headers);
        reader.from_reader(part.as_bytes())
    }

    /// Divides the text after the header at ends of lines. A quoted field may contain ends of lines.
    fn parts(&self) -> Vec<Range<usize>> {
        let size = if self.text.contains('"') { self.text.len() } else { PART };
        let mut parts = Vec::new();
        let mut at = self.body.min(self.text.len());
        while at < self.text.len() {
            let rest = &self.text.as_bytes()[(at + size).min(self.text.len())..];
            let end = self.text.len() - rest.len()
                + rest.iter().position(|&byte| byte == b'\n').map_or(rest.len(), |i| i + 1);
            parts.push(at..end);
            at = end;
        }
        parts
    }

    /// Reads the rows of a part of the text.
    fn rows(&self, part: Range<usize>) -> Rows {
        let has_colors = self.columns.iter().any(|(column, _)| column.is_optional());
        let has_degrees = self.columns.iter().any(|(column, _)| *column == Column::Degrees);
        let mut rows = Rows { stars: Vec::new(), may_be_hours: has_degrees, mistakes: Vec::new() };
        let mut reader = self.reader(&self.text[part.clone()], false);
        let mut record = ByteRecord::new();
        while rows.mistakes.len() < ENOUGH {
            match reader.read_byte_record(&mut record) {
                Ok(true) => {}
                Ok(false) => break,
                Err(error) => {
                    rows.mistakes.push(self.unreadable(part.start, &error));
                    break;
                }
            }
            let start = part.start + record.position().map_or(0, |place| place.byte() as usize);
            match self.values(&record, start) {
                Ok(values) => {
                    rows.may_be_hours &= values.ascension() <= 24.0;
                    rows.stars.push(Star::of(&values, has_colors));
                }
                Err(mistake) => rows.mistakes.push(mistake),
            }
        }
        rows
    }

    /// Returns the columns of a header.
    fn columns(&self, head: &ByteRecord) -> Result<Vec<(Column, usize)>, Mistake> {
        let kind = |name: &[u8]| {
            let name = String::from_utf8_lossy(name).trim().to_lowercase();
            NAMES.iter().find(|(own, _)| *own == name).map(|(_, column)| *column)
        };
        let mut found: Vec<(Column, usize)> = Vec::new();
        for (at, column) in head.iter().enumerate().filter_map(|(at, name)| Some((at, kind(name)?))) {
            // The first of several columns of a kind is used.
            if found.iter().all(|(known, _)| *known != column) {
                found.push((column, at));
            }
        }
        let has = |wanted: &[Column]| found.iter().any(|(column, _)| wanted.contains(column));
        let required: [(&str, &[Column]); 3] =
            [("ra", &[Column::Degrees, Column::Hours]), ("dec", &[Column::Declination]), ("mag", &[Column::Magnitude])];
        if let Some((name, kinds)) = required.into_iter().find(|(_, kinds)| !has(kinds)) {
            let others: Vec<&str> =
                NAMES.iter().filter(|(own, kind)| kinds.contains(kind) && *own != name).map(|(own, _)| *own).collect();
            let all: Vec<_> = head.iter().map(String::from_utf8_lossy).collect();
            let found = if all.is_empty() { "an empty file".to_owned() } else { all.join(", ") };
            let problem = format!("no column `{name}`, found {found}");
            let help = format!("name a column {name}, or one of {}", others.join(", "));
            return Err(self.mistake(0, 0, problem, help));
        }
        Ok(found)
    }

    /// Returns the values of a record that starts at or after a byte of the text.
    fn values(&self, record: &ByteRecord, start: usize) -> Result<Values, Mistake> {
        let mut values = Values([f64::NAN; 6]);
        for &(column, at) in &self.columns {
            let text = record.get(at).and_then(|field| std::str::from_utf8(field).ok()).unwrap_or_default().trim();
            if text.is_empty() && column.is_optional() {
                continue;
            }
            let (range, what) = column.range();
            let value = text.parse().ok().filter(|value| range.contains(value));
            let mistake = || self.mistake(start, at, format!("expected {what}, found `{text}`"), String::new());
            values.0[column as usize] = value.ok_or_else(mistake)?;
        }
        Ok(values)
    }

    /// Returns a mistake at the field `at` of the record that starts at or after a byte of the text.
    fn mistake(&self, start: usize, at: usize, problem: String, help: String) -> Mistake {
        let is_skipped = |line: &str| line.trim().is_empty() || line.starts_with('#');
        let lines = self.text[start..].split_inclusive('\n');
        let skipped: usize = lines.take_while(|line| is_skipped(line)).map(str::len).sum();
        // Quotes enclose marks that do not separate fields.
        let outside = |wanted: char| {
            let mut is_quoted = false;
            move |mark: char| {
                is_quoted ^= mark == '"';
                mark == wanted && !is_quoted
            }
        };
        let row = self.text[start + skipped..].split(outside('\n')).next().unwrap_or_default();
        let field = row.split(outside(self.separator)).nth(at).unwrap_or(row);
        let field = if field.trim().is_empty() { field } else { field.trim() };
        // A slice's offset is the distance between the two addresses.
        let start = field.as_ptr() as usize - self.text.as_ptr() as usize;
        Mistake { place: start..start + field.len(), problem, help }
    }

    /// Returns a mistake in a part of the file, from a byte on, that is not a table.
    fn unreadable(&self, start: usize, error: &csv::Error) -> Mistake {
        let start = start + error.position().map_or(0, |place| place.byte() as usize);
        let place = start..self.text.len().min(start + 1);
        Mistake { place, problem: format!("not a table: {error}"), help: "separate columns by commas".to_owned() }
    }
}
