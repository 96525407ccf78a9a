//! The output tables of `bentray trace`, `light` and `compare`: CSV, or the columns as arrays for `NumPy` (`.npz`).
//!
//! CSV has one header line, commas, and no quotes. Numbers are written in the shortest form that parses as the identical `f64`. The writer of
//! CSV stores one row, and the one of arrays the whole table.

use std::io::{self, BufWriter, ErrorKind, Stdout, Write};
use std::path::Path;

use glam::DMat2;

use super::npy::{array_file, write_archive};
use super::{AtomicFile, OutputError, has_extension};
use crate::measure::{Jacobian, OpticalPath};
use crate::render::{Crossing, PathPoint, Traced, Transferred};

/// A path from a light to a position, or its absence.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightRow {
    /// The index of the position in the input.
    pub place: usize,
    /// The index of the light in the scene file.
    pub light: usize,
    /// The status: lit, shadowed by an object on the path, without a path, or outside the light grid.
    pub status: &'static str,
    /// The unit direction at the light.
    pub leaves: Option<[f64; 3]>,
    /// The unit direction at the position.
    pub arrives: Option<[f64; 3]>,
    /// The perpendicular area of the bundle at the position per solid angle at the light.
    pub spread: Option<f64>,
}

/// A value in a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Field {
    /// A whole number from 0; `None` for none, which is empty in CSV and -1 in an array.
    Index(Option<u64>),
    /// A number; `None` if there is none, which is empty in CSV and NaN in an array.
    Number(Option<f64>),
    /// The result of a measurement, of which CSV has seven digits.
    Measured(f64),
    /// A word without commas.
    Word(&'static str),
}

/// A row of a table.
pub trait Row {
    /// The names of the columns.
    const COLUMNS: &'static [&'static str];

    /// Returns the values, one for each column and of the same kind in every row.
    fn fields(&self) -> Vec<Field>;
}

/// A ray by its index in the input, with its end.
impl Row for (usize, &Traced) {
    const COLUMNS: &'static [&'static str] =
        &["ray", "status", "x", "y", "z", "vx", "vy", "vz", "tau", "segments", "steps", "rejected", "object"];

    fn fields(&self) -> Vec<Field> {
        let (ray, Traced { status, x, v, tau, segments, steps, rejected, object }) = *self;
        let first = [index(ray), Field::Word(status.name())];
        let counts = [Field::Index(Some((*steps).into())), Field::Index(Some((*rejected).into()))];
        let object = Field::Index(object.map(u64::from));
        let numbers = [*x, *v].concat().into_iter().chain([*tau, *segments]).map(|value| Field::Number(Some(value)));
        first.into_iter().chain(numbers).chain(counts).chain([object]).collect()
    }
}

/// A ray by its index in the input, and a point of its path, counted from 0.
impl Row for (usize, usize, &PathPoint) {
    const COLUMNS: &'static [&'static str] = &["ray", "index", "x", "y", "z", "vx", "vy", "vz", "tau"];

    fn fields(&self) -> Vec<Field> {
        let (ray, place, PathPoint { x, v, tau }) = *self;
        let numbers = [*x, *v].concat().into_iter().chain([*tau]).map(|value| Field::Number(Some(value)));
        [index(ray), index(place)].into_iter().chain(numbers).collect()
    }
}

/// A ray by its index in the input, the order of a crossing, and the crossing.
impl Row for (usize, usize, &Crossing) {
    const COLUMNS: &'static [&'static str] =
        &["ray", "order", "object", "x", "y", "z", "tau", "r", "phi", "t", "g", "angle"];

    fn fields(&self) -> Vec<Field> {
        let (ray, order, Crossing { object, x, tau, radius, azimuth, time, redshift, angle }) = *self;
        let first = [index(ray), index(order), index(*object as usize)];
        let place = x.iter().chain([tau, radius, azimuth]).map(|value| Some(*value));
        first.into_iter().chain(place.chain([*time, *redshift, *angle]).map(Field::Number)).collect()
    }
}

/// A ray by its index in the input, its end, and the change of the end with the direction at the start.
impl Row for (usize, &Traced, Option<Jacobian>) {
    const COLUMNS: &'static [&'static str] =
        &["ray", "status", "magnification", "d11", "d12", "d21", "d22", "x11", "x12", "x21", "x22"];

    fn fields(&self) -> Vec<Field> {
        let (ray, end, jacobian) = *self;
        let magnification = jacobian.map(|jacobian| jacobian.magnification());
        let rows = |of: fn(&Jacobian) -> DMat2| {
            let matrix = jacobian.as_ref().map(of);
            [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(row, column)| matrix.map(|matrix| matrix.row(row)[column]))
        };
        let numbers = [magnification].into_iter().chain(rows(|j| j.direction)).chain(rows(|j| j.position));
        [index(ray), Field::Word(end.status.name())].into_iter().chain(numbers.map(Field::Number)).collect()
    }
}

/// A ray by its index in the input, with the lengths of its path.
impl Row for (usize, OpticalPath) {
    const COLUMNS: &'static [&'static str] = &["ray", "status", "length", "optical_path"];

    fn fields(&self) -> Vec<Field> {
        let (ray, OpticalPath { status, length, optical }) = *self;
        vec![index(ray), Field::Word(status.name()), Field::Number(Some(length)), Field::Number(Some(optical))]
    }
}

/// A ray by its index in the input, its end, a frequency, and its light at that frequency.
impl Row for (usize, &Traced, f64, Transferred) {
    const COLUMNS: &'static [&'static str] = &["ray", "status", "frequency", "intensity", "optical_depth"];

    fn fields(&self) -> Vec<Field> {
        let (ray, end, frequency, Transferred { intensity, optical_depth }) = *self;
        let numbers = [frequency, intensity, optical_depth].map(|value| Field::Number(Some(value)));
        [index(ray), Field::Word(end.status.name())].into_iter().chain(numbers).collect()
    }
}

impl Row for LightRow {
    const COLUMNS: &'static [&'static str] = &[
        "place",
        "light",
        "status",
        "leaves_x",
        "leaves_y",
        "leaves_z",
        "arrives_x",
        "arrives_y",
        "arrives_z",
        "spread",
    ];

    fn fields(&self) -> Vec<Field> {
        let vectors = [self.leaves, self.arrives].into_iter().flat_map(|v| v.map_or([None; 3], |v| v.map(Some)));
        let first = [index(self.place), index(self.light), Field::Word(self.status)];
        first.into_iter().chain(vectors.chain([self.spread]).map(Field::Number)).collect()
    }
}

fn index(value: usize) -> Field {
    Field::Index(Some(value as u64))
}

impl Field {
    /// Returns the text in CSV.
    fn text(self) -> String {
        match self {
            Self::Index(value) => value.map(|value| value.to_string()).unwrap_or_default(),
            Self::Number(value) => value.map(number).unwrap_or_default(),
            Self::Measured(value) => format!("{value:.6e}"),
            Self::Word(word) => word.to_owned(),
        }
    }
}

/// The values of a column of a table.
#[derive(Debug, Default)]
enum Column {
    #[default]
    Empty,
    Indices(Vec<i64>),
    Numbers(Vec<f64>),
    Words(Vec<&'static str>),
}

impl Column {
    /// Appends a value of the kind of the first.
    fn push(&mut self, field: Field) {
        if matches!(self, Self::Empty) {
            *self = match field {
                Field::Index(_) => Self::Indices(Vec::new()),
                Field::Number(_) | Field::Measured(_) => Self::Numbers(Vec::new()),
                Field::Word(_) => Self::Words(Vec::new()),
            };
        }
        match (self, field) {
            (Self::Indices(all), Field::Index(value)) => all.push(value.map_or(-1, u64::cast_signed)),
            (Self::Numbers(all), Field::Number(value)) => all.push(value.unwrap_or(f64::NAN)),
            (Self::Numbers(all), Field::Measured(value)) => all.push(value),
            (Self::Words(all), Field::Word(word)) => all.push(word),
            (_, field) => debug_assert!(false, "{field:?} in another kind of column"),
        }
    }

    /// Returns the array's file; words have as many characters of 32 bits as the longest.
    fn file(&self) -> Vec<u8> {
        match self {
            Self::Empty => array_file("<f8", 0, &[]),
            Self::Indices(all) => array_file("<i8", all.len(), &joined(all.iter().map(|value| value.to_le_bytes()))),
            Self::Numbers(all) => array_file("<f8", all.len(), &joined(all.iter().map(|value| value.to_le_bytes()))),
            Self::Words(all) => {
                let longest = all.iter().map(|word| word.chars().count()).max().unwrap_or(0).max(1);
                let letters =
                    |word: &'static str| word.chars().map(u32::from).chain(std::iter::repeat(0)).take(longest);
                let values = all.iter().flat_map(|word| letters(word)).map(u32::to_le_bytes);
                array_file(&format!("<U{longest}"), all.len(), &joined(values))
            }
        }
    }
}

fn joined<const N: usize>(values: impl Iterator<Item = [u8; N]>) -> Vec<u8> {
    values.flatten().collect()
}

/// Formats a number in the shortest form that parses as the same value, as an f32 if it is one. `{:?}` avoids the zeros that `{}` would
/// write for 1e300.
pub(super) fn number(value: f64) -> String {
    let single = value as f32;
    if f64::from(single).to_bits() == value.to_bits() || value.is_nan() {
        format!("{single:?}")
    } else {
        format!("{value:?}")
    }
}

/// A writer of a table to standard output, or to a file that is written completely or not at all.
#[derive(Debug)]
pub struct Table {
    sink: Sink,
}

#[derive(Debug)]
enum Sink {
    File(AtomicFile),
    /// The file of an `.npz`, and its columns.
    Arrays(AtomicFile, Vec<(&'static str, Column)>),
    Stdout(BufWriter<Stdout>),
    /// Standard output with a closed reader, such as `head` after its last line.
    Closed,
}

impl Table {
    /// Starts a table with the columns of `R`: an `.npz` by its extension, otherwise CSV. The path `-` is standard output; after its reader
    /// closes, rows are discarded.
    ///
    /// # Errors
    ///
    /// Returns an error if the file cannot be created ([`AtomicFile::create`]), or the header cannot be written.
    ///
    /// # Examples
    ///
    /// ```
    /// use bentray::{output::table::Table, render::PathPoint};
    ///
    /// let folder = tempfile::tempdir()?;
    /// let path = folder.path().join("path.csv");
    /// let mut table = Table::create::<(usize, usize, &PathPoint)>(&path)?;
    /// table.write(&(0, 0, &PathPoint { x: [1.0, 0.0, 0.0], v: [0.0, 1.0, 0.0], tau: 0.5 }))?;
    /// table.finish()?;
    /// assert_eq!(std::fs::read_to_string(path)?, "ray,index,x,y,z,vx,vy,vz,tau\n0,0,1.0,0.0,0.0,0.0,1.0,0.0,0.5\n");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn create<R: Row>(path: &Path) -> Result<Self, OutputError> {
        let sink = if path == Path::new("-") {
            Sink::Stdout(BufWriter::new(io::stdout()))
        } else if has_extension(path, "npz") {
            let columns = R::COLUMNS.iter().map(|name| (*name, Column::default())).collect();
            return Ok(Self { sink: Sink::Arrays(AtomicFile::create(path)?, columns) });
        } else {
            Sink::File(AtomicFile::create(path)?)
        };
        let mut table = Self { sink };
        table.line(&R::COLUMNS.join(","))?;
        Ok(table)
    }

    /// Appends a row, which must be of the type of the columns.
    ///
    /// # Errors
    ///
    /// Returns [`OutputError::Write`] or [`OutputError::Stdout`] if writing fails.
    pub fn write<R: Row>(&mut self, row: &R) -> Result<(), OutputError> {
        let fields = row.fields();
        if let Sink::Arrays(_, columns) = &mut self.sink {
            columns.iter_mut().zip(fields).for_each(|((_, column), field)| column.push(field));
            return Ok(());
        }
        self.line(&fields.into_iter().map(Field::text).collect::<Vec<_>>().join(","))
    }

    /// Finishes the file, or flushes standard output.
    ///
    /// # Errors
    ///
    /// Returns [`OutputError::Write`] or [`OutputError::Stdout`] if writing fails; an existing file is then unchanged.
    pub fn finish(self) -> Result<(), OutputError> {
        match self.sink {
            Sink::File(file) => file.finish(),
            Sink::Arrays(file, columns) => {
                write_archive(file, columns.iter().map(|(name, column)| (*name, column.file())))?.finish()
            }
            Sink::Stdout(mut out) => match out.flush() {
                Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
                flushed => flushed.map_err(OutputError::Stdout),
            },
            Sink::Closed => Ok(()),
        }
    }

    fn line(&mut self, line: &str) -> Result<(), OutputError> {
        match &mut self.sink {
            Sink::File(file) => writeln!(file, "{line}").map_err(|e| file.failed(e)),
            Sink::Stdout(out) => match writeln!(out, "{line}") {
                Err(error) if error.kind() == ErrorKind::BrokenPipe => {
                    self.sink = Sink::Closed;
                    Ok(())
                }
                written => written.map_err(OutputError::Stdout),
            },
            Sink::Arrays(..) | Sink::Closed => Ok(()),
        }
    }
}
