//! Tables of `bentray trace`: the input of rays, and the output of results and paths.
//!
//! Both are plain CSV: one header line, commas, and no quotes except for text that contains a comma or a quote. Numbers are written in the
//! shortest form that parses as the identical `f64`. The reader skips empty lines and comments, which begin with `#`, and stores the whole
//! file, about 100 bytes per ray; the writer stores one row.

use std::{
    io::{self, BufWriter, ErrorKind, Stdout, Write},
    path::Path,
};

use super::{AtomicFile, OutputError};
use crate::document::{SceneError, given_name, read_given, strict_text};
use crate::render::{PathPoint, Traced};

/// The columns of a file of rays: a position and a velocity.
pub const RAY_COLUMNS: [&str; 6] = ["x", "y", "z", "vx", "vy", "vz"];

/// The length of the smallest velocity whose square is representable in 32 bits; a shorter one has no direction.
const LEAST_SPEED: f64 = 1e-18;

/// The columns of a file of positions.
pub const PLACE_COLUMNS: [&str; 3] = ["x", "y", "z"];

/// Reads a file of rays as `[x, y, z, vx, vy, vz]`, in any order of columns; the path `-` is standard input.
///
/// The first line lists the columns, which must be exactly those of [`RAY_COLUMNS`]; spaces around fields and empty lines are ignored.
/// Every number must be finite, and there must be at least one ray. With `aimed`, every ray must have a direction: a velocity longer than
/// 1e-18, whose square is representable in 32 bits.
///
/// # Errors
///
/// Returns the line and its problem, or why the file cannot be read.
pub fn read_rays(path: &Path, aimed: bool) -> Result<Vec<[f64; 6]>, OutputError> {
    let check = |[.., x, y, z]: &[f64; 6]| {
        let is_aimed = !aimed || x.hypot(*y).hypot(*z) > LEAST_SPEED;
        let problem =
            || format!("the velocity {} has no direction; use a nonzero vector such as 0,0,-1", numbers([*x, *y, *z]));
        if is_aimed { Ok(()) } else { Err(problem()) }
    };
    read_numbers(path, "rays", &RAY_COLUMNS, check)
}

/// Reads a file of positions, as [`read_rays`] reads rays.
///
/// # Errors
///
/// Returns [`OutputError::Read`] if the file cannot be read, and [`OutputError::Table`] with the line and its problem if it is invalid.
pub fn read_places(path: &Path) -> Result<Vec<[f64; 3]>, OutputError> {
    read_numbers(path, "points", &PLACE_COLUMNS, |_| Ok(()))
}

/// Reads rows of numbers; `what` is the name of the rows in messages, and `check` returns the problem of a row.
fn read_numbers<const N: usize>(
    path: &Path,
    what: &str,
    columns: &[&str; N],
    check: impl Fn(&[f64; N]) -> Result<(), String>,
) -> Result<Vec<[f64; N]>, OutputError> {
    let name = given_name(path);
    let bytes = read_given(path).map_err(|cause| OutputError::Read { path: name.to_owned(), cause })?;
    let text = strict_text(bytes, name).map_err(|error| {
        let (line, problem) = match &error {
            SceneError::Diagnostics(all) if !all.is_empty() => {
                (all[0].line, format!("{}; {}", all[0].problem, all[0].help))
            }
            other => (1, other.to_string()),
        };
        OutputError::Table { path: name.to_owned(), line, problem }
    })?;
    let parsed = parse_numbers(&text, what, columns, check);
    parsed.map_err(|(line, problem)| OutputError::Table { path: name.to_owned(), line, problem })
}

/// A line number, from 1, and its problem.
type SpannedError = (usize, String);

fn parse_numbers<const N: usize>(
    text: &str,
    what: &str,
    columns: &[&str; N],
    check: impl Fn(&[f64; N]) -> Result<(), String>,
) -> Result<Vec<[f64; N]>, SpannedError> {
    let is_data = |line: &str| !line.is_empty() && !line.starts_with('#');
    let mut lines = text.lines().enumerate().map(|(i, line)| (i + 1, line)).filter(|(_, line)| is_data(line.trim()));
    let expected = columns.join(",");
    let (line, header) = lines.next().ok_or_else(|| (1, format!("the file is empty; begin it with {expected}")))?;
    let order = column_order(header, what, columns).map_err(|problem| (line, problem))?;
    let checked = |numbers| check(&numbers).map(|()| numbers);
    let row = |(line, row)| parse_row(row, &order, columns).and_then(checked).map_err(|problem| (line, problem));
    let rows: Vec<_> = lines.map(row).collect::<Result<_, _>>()?;
    if rows.is_empty() {
        return Err((line, format!("no {what} after the header; write one per line")));
    }
    Ok(rows)
}

/// Returns the index of the wanted column for each column of the file.
fn column_order(header: &str, what: &str, columns: &[&str]) -> Result<Vec<usize>, String> {
    let expected = columns.join(",");
    let mut order = Vec::new();
    for (i, name) in header.split(',').map(str::trim).enumerate() {
        let Some(column) = columns.iter().position(|c| *c == name) else {
            return Err(format!(
                "column {}: `{name}` is not a valid column for {what}; the first line must contain {expected}",
                i + 1
            ));
        };
        if order.contains(&column) {
            return Err(format!("column {}: `{name}` occurs twice; remove one", i + 1));
        }
        order.push(column);
    }
    match (0..columns.len()).find(|column| !order.contains(column)) {
        Some(missing) => Err(format!(
            "missing column `{}` in `{}`; the first line must contain {expected}",
            columns[missing],
            header.trim()
        )),
        None => Ok(order),
    }
}

fn parse_row<const N: usize>(row: &str, order: &[usize], columns: &[&str; N]) -> Result<[f64; N], String> {
    let fields: Vec<_> = row.split(',').map(str::trim).collect();
    if fields.len() != order.len() {
        return Err(format!("`{}` has {} fields; expected {}, one per column", row.trim(), fields.len(), order.len()));
    }
    let mut numbers = [0.0; N];
    for (i, (field, &column)) in fields.iter().zip(order).enumerate() {
        numbers[column] = match field.parse::<f64>() {
            Ok(value) if value.abs() <= 1e30 => value,
            _ => {
                return Err(format!(
                    "column {} ({}): expected a finite number such as 1.5 or -2e-3, found `{field}`",
                    i + 1,
                    columns[column]
                ));
            }
        };
    }
    Ok(numbers)
}

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

/// A row of a table, with the header of the table.
pub trait Row {
    /// The header line.
    const HEADER: &'static str;

    /// Returns the fields of the row, separated by commas.
    fn line(&self) -> String;
}

/// A ray by its index in the input, with its end; without an object the last field is empty.
impl Row for (usize, &Traced) {
    const HEADER: &'static str = "ray,status,x,y,z,vx,vy,vz,tau,segments,steps,rejected,object";

    fn line(&self) -> String {
        let (ray, Traced { status, x, v, tau, segments, steps, rejected, object }) = self;
        let [x, v, tau, segments] = [numbers(*x), numbers(*v), number(*tau), number(*segments)];
        let object = object.map(|object| object.to_string()).unwrap_or_default();
        format!("{ray},{},{x},{v},{tau},{segments},{steps},{rejected},{object}", status.name())
    }
}

/// A ray by its index in the input, and a point of its path, counted from 0.
impl Row for (usize, usize, &PathPoint) {
    const HEADER: &'static str = "ray,index,x,y,z,vx,vy,vz,tau";

    fn line(&self) -> String {
        let (ray, index, PathPoint { x, v, tau }) = self;
        format!("{ray},{index},{},{},{}", numbers(*x), numbers(*v), number(*tau))
    }
}

impl Row for LightRow {
    const HEADER: &'static str = "place,light,status,leaves_x,leaves_y,leaves_z,arrives_x,arrives_y,arrives_z,spread";

    fn line(&self) -> String {
        let vector = |v: Option<[f64; 3]>| v.map_or_else(|| ",,".to_owned(), numbers);
        let spread = self.spread.map(number).unwrap_or_default();
        let (leaves, arrives) = (vector(self.leaves), vector(self.arrives));
        format!("{},{},{},{leaves},{arrives},{spread}", self.place, self.light, self.status)
    }
}

/// Formats a number in the shortest form that parses as the same value, as an f32 if it is one. `{:?}` avoids the zeros that `{}` would
/// write for 1e300.
fn number(value: f64) -> String {
    let single = value as f32;
    if f64::from(single).to_bits() == value.to_bits() || value.is_nan() {
        format!("{single:?}")
    } else {
        format!("{value:?}")
    }
}

fn numbers([x, y, z]: [f64; 3]) -> String {
    format!("{},{},{}", number(x), number(y), number(z))
}

/// A writer of a table to standard output, or to a file that is written completely or not at all.
#[derive(Debug)]
pub struct Table {
    sink: Sink,
}

#[derive(Debug)]
enum Sink {
    File(AtomicFile),
    Stdout(BufWriter<Stdout>),
    /// Standard output with a closed reader, such as `head` after its last line.
    Closed,
}

impl Table {
    /// Starts a table with the header of `R`; the path `-` is standard output. After its reader closes, rows are discarded.
    ///
    /// # Errors
    ///
    /// Returns an error if the file cannot be created ([`AtomicFile::create`]), or the header cannot be written.
    ///
    /// # Examples
    ///
    /// ```
    /// use bentray::{output::csv::Table, render::PathPoint};
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
        } else {
            Sink::File(AtomicFile::create(path)?)
        };
        let mut table = Self { sink };
        table.line(R::HEADER)?;
        Ok(table)
    }

    /// Appends a row, which must be of the type of the header.
    ///
    /// # Errors
    ///
    /// Returns [`OutputError::Write`] or [`OutputError::Stdout`] if writing fails.
    pub fn write<R: Row>(&mut self, row: &R) -> Result<(), OutputError> {
        self.line(&row.line())
    }

    /// Finishes the file, or flushes standard output.
    ///
    /// # Errors
    ///
    /// Returns [`OutputError::Write`] or [`OutputError::Stdout`] if writing fails; an existing file is then unchanged.
    pub fn finish(self) -> Result<(), OutputError> {
        match self.sink {
            Sink::File(file) => file.finish(),
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
            Sink::Closed => Ok(()),
        }
    }
}
