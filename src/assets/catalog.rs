//! Star catalogs: directions, magnitudes and colors of stars from a table in CSV.
//!
//! *Practice.* The first line that is not a comment names the columns, in the usual words of public catalogs; other columns are ignored.
//! Columns are separated by commas, semicolons or tabs. A color index B−V determines a temperature, T = 4600 K (1/(0.92 (B−V) + 1.7) +
//! 1/(0.92 (B−V) + 0.62)) (Ballesteros 2012).

use std::fmt;
use std::ops::RangeInclusive;
use std::path::Path;

use csv::{ByteRecord, ReaderBuilder};
use glam::DVec3;

use crate::document::{Diagnostic, SceneError, read_text};

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

/// The stars of a file, in its order.
#[derive(Clone, PartialEq)]
pub struct Catalog {
    /// The name of the file.
    pub name: String,
    /// All stars.
    pub stars: Vec<Star>,
    /// `true` if every right ascension is at most 24, so that hours may have been meant.
    pub may_be_hours: bool,
}

impl fmt::Debug for Catalog {
    /// Writes the name and the number of stars.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { name, stars, may_be_hours } = self;
        f.debug_struct("Catalog")
            .field("name", name)
            .field("stars", &stars.len())
            .field("may_be_hours", may_be_hours)
            .finish()
    }
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

/// The largest number of stars.
const MOST: usize = 1 << 24;
/// The number of errors after which a file is not read further.
const ENOUGH: usize = 10;
/// The color index of a star whose color is unknown: that of the sun.
const USUAL_INDEX: f64 = 0.65;

impl Catalog {
    /// Reads a file.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Read`] if the file cannot be read, and otherwise the errors of [`parse`](Self::parse).
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        Self::parse(&read_text(path)?, path)
    }

    /// Reads the text of a file; `path` names it in errors.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Diagnostics`] if a column is missing or a value is invalid.
    pub fn parse(text: &str, path: &Path) -> Result<Self, SceneError> {
        let table = Table { text, path };
        let head = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#')).unwrap_or_default();
        let separator = [b'\t', b';', b','].into_iter().find(|&mark| head.contains(char::from(mark))).unwrap_or(b',');
        let mut reader = ReaderBuilder::new();
        reader.delimiter(separator).comment(Some(b'#')).flexible(true).trim(csv::Trim::All);
        let mut reader = reader.from_reader(text.as_bytes());
        let columns = table.columns(reader.byte_headers().map_err(|error| table.unreadable(&error))?)?;
        let mut catalog = Self {
            name: path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            stars: Vec::new(),
            may_be_hours: columns[0].0 == Column::Degrees,
        };
        let (mut mistakes, mut record) = (Vec::new(), ByteRecord::new());
        while reader.read_byte_record(&mut record).map_err(|error| table.unreadable(&error))? {
            let values = columns.iter().map(|&(column, at)| table.value(&record, column, at));
            match values.collect::<Result<Vec<f64>, Box<Diagnostic>>>() {
                Ok(values) => catalog.add(&columns, &values),
                Err(mistake) => mistakes.push(*mistake),
            }
            if catalog.stars.len() > MOST {
                mistakes.push(table.mistake(&record, 0, format!("more than {MOST} stars"), "leave out the faintest"));
            }
            if mistakes.len() >= ENOUGH || catalog.stars.len() > MOST {
                break;
            }
        }
        if mistakes.is_empty() { Ok(catalog) } else { Err(SceneError::Diagnostics(mistakes)) }
    }

    /// Adds a star with these values of the columns.
    fn add(&mut self, columns: &[(Column, usize)], values: &[f64]) {
        let of = |wanted: Column| {
            let at = columns.iter().position(|(column, _)| *column == wanted);
            at.map(|at| values[at]).filter(|value| !value.is_nan())
        };
        let ascension = of(Column::Degrees).or_else(|| of(Column::Hours).map(|hours| 15.0 * hours)).unwrap_or_default();
        self.may_be_hours &= ascension <= 24.0;
        let has_colors = columns.iter().any(|(column, _)| column.is_optional());
        let kelvins = of(Column::Temperature).or_else(|| has_colors.then(|| temperature(of(Column::ColorIndex))));
        self.stars.push(Star {
            direction: direction(ascension, of(Column::Declination).unwrap_or_default()),
            magnitude: of(Column::Magnitude).unwrap_or_default() as f32,
            kelvins: kelvins.unwrap_or_default() as f32,
        });
    }

    /// Returns a message if hours may have been meant.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        /// The number of stars that are not all within 24 degrees by chance.
        const MANY: usize = 100;
        let (name, is_so) = (&self.name, self.may_be_hours && self.stars.len() >= MANY);
        is_so.then(|| {
            format!(
                "{name}: every `ra` is at most 24; degrees are expected, so name the column `ra_h` if these are hours"
            )
        })
    }

    /// Returns the memory that the stars take, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        (self.stars.len() * size_of::<Star>()) as u64
    }
}

/// Returns the direction of a star, from degrees. Right ascension increases to the left, as in maps of the sky seen from inside.
fn direction(ascension: f64, declination: f64) -> DVec3 {
    let ((sin_a, cos_a), (sin_d, cos_d)) = (ascension.to_radians().sin_cos(), declination.to_radians().sin_cos());
    DVec3::new(-cos_d * sin_a, sin_d, -cos_d * cos_a)
}

/// Returns the temperature of a color index B−V, in kelvins. The formula has a pole at −0.67, and is used where it was fitted.
fn temperature(color_index: Option<f64>) -> f64 {
    let index = 0.92 * color_index.unwrap_or(USUAL_INDEX).clamp(-0.4, 4.0);
    4600.0 * (1.0 / (index + 1.7) + 1.0 / (index + 0.62))
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

/// A file, for the places of errors.
struct Table<'t> {
    text: &'t str,
    path: &'t Path,
}

impl Table<'_> {
    /// Returns the columns of a header, the right ascension first.
    fn columns(&self, head: &ByteRecord) -> Result<Vec<(Column, usize)>, SceneError> {
        let kind = |name: &[u8]| {
            let name = String::from_utf8_lossy(name).to_lowercase();
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
            return Err(SceneError::Diagnostics(vec![self.mistake(head, 0, problem, &help)]));
        }
        found.sort_by_key(|(column, _)| !matches!(column, Column::Degrees | Column::Hours));
        Ok(found)
    }

    /// Returns a value of a record; NaN if it is missing and may be.
    fn value(&self, record: &ByteRecord, column: Column, at: usize) -> Result<f64, Box<Diagnostic>> {
        let text = record.get(at).and_then(|field| std::str::from_utf8(field).ok()).unwrap_or_default();
        if text.is_empty() && column.is_optional() {
            return Ok(f64::NAN);
        }
        let (range, what) = column.range();
        let value = text.parse().ok().filter(|value| range.contains(value));
        value.ok_or_else(|| Box::new(self.mistake(record, at, format!("expected {what}, found `{text}`"), "")))
    }

    /// Returns an error at a field of a record.
    fn mistake(&self, record: &ByteRecord, at: usize, problem: String, help: &str) -> Diagnostic {
        let line = record.position().map_or(1, csv::Position::line).saturating_sub(1);
        let row = self.text.lines().nth(line as usize).unwrap_or_default();
        let part = row.split([',', ';', '\t']).nth(at).unwrap_or(row);
        let part = if record.len() > 1 && part.trim().is_empty() { part } else { part.trim() };
        Diagnostic::of(self.path, self.text, part, problem, help.to_owned())
    }

    /// Returns an error about a file that is not a table.
    fn unreadable(&self, error: &csv::Error) -> SceneError {
        let start = error.position().map_or(0, |place| place.byte() as usize);
        let end = self.text.len().min(start + 1);
        let problem = format!("not a table: {error}");
        SceneError::Diagnostics(vec![Diagnostic::locate(
            self.path.to_owned(),
            self.text,
            start,
            end,
            problem,
            "separate columns by commas".to_owned(),
        )])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> Catalog {
        Catalog::parse(text, Path::new("s.csv")).unwrap()
    }

    #[test]
    fn columns_have_the_names_of_public_catalogs() {
        let of = |head: &str, row: &str| parsed(&format!("{head}\n{row}\n")).stars;
        let expected = of("ra,dec,mag,b_v", "90,0,1.5,0.65");
        assert!((expected[0].direction - DVec3::NEG_X).length() < 1e-15);
        for (head, row) in [
            ("# a catalog\nRA_h;DEC;Vmag;B-V;name", "6;0;1.5;;Sol"),
            ("name\traj2000\tdej2000\tmag\tci", "\"a, b\"\t 90 \t0\t1.5\t"),
        ] {
            assert_eq!(of(head, row), expected, "{head}");
        }
    }

    #[test]
    fn mistakes_have_places() {
        let place = |text: &str| match Catalog::parse(text, Path::new("s.csv")) {
            Err(SceneError::Diagnostics(all)) => all.iter().map(|one| (one.line, one.column)).collect::<Vec<_>>(),
            other => panic!("{text}: {other:?}"),
        };
        assert_eq!(place("ra,dec,vt\n1,2,3\n"), [(1, 1)]);
        assert_eq!(place("ra,dec,mag\n1,2,3\n1,123.4,3\nnan,1,2\n1,2,inf\n1,2\n"), [(3, 3), (4, 1), (5, 5), (6, 1)]);
    }

    #[test]
    fn hours_that_are_called_degrees_are_noticed() {
        let of = |step: f64| {
            let rows = (0..200).map(|i| format!("{},0,1\n", f64::from(i) * step));
            parsed(&format!("ra,dec,mag\n{}", rows.collect::<String>())).warning()
        };
        assert_eq!([of(0.12).is_some(), of(1.2).is_some()], [true, false]);
    }

    #[test]
    fn blue_stars_are_hot() {
        let kelvins = [-0.4, 0.0, 0.65, 1.5, f64::NAN].map(|index| temperature(Some(index).filter(|x| !x.is_nan())));
        assert!((kelvins[2] - 5_780.0).abs() < 30.0, "{}", kelvins[2]);
        assert!(kelvins.windows(2).take(3).all(|pair| pair[0] > pair[1]));
        assert_eq!(kelvins[4].to_bits(), kelvins[2].to_bits());
    }
}
