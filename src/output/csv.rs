//! Tables for `bentray trace`: rays come in, results and paths go out.
//!
//! Both are plain CSV by hand: one header line, commas, and no quoting but for text that holds a comma or a quote.
//! Numbers go out in the shortest form that reads back as the same `f64`. Reading holds the whole file, 100 bytes or
//! so per ray; writing holds one row.

use std::{
    fs,
    io::{self, BufWriter, Stdout, Write},
    path::Path,
};

use super::{AtomicFile, OutputError};

/// The columns of a file of rays: a place and a velocity.
pub const RAY_COLUMNS: [&str; 6] = ["x", "y", "z", "vx", "vy", "vz"];

/// Reads a file of rays, each as `[x, y, z, vx, vy, vz]` whatever the order of the columns.
///
/// The first line names the columns, which must be exactly those of [`RAY_COLUMNS`]; spaces around fields and empty
/// lines are passed over. Every number must be finite, and there must be at least one ray.
pub fn read_rays(path: &Path) -> Result<Vec<[f64; 6]>, OutputError> {
    let text = fs::read_to_string(path).map_err(|cause| OutputError::Read { path: path.to_owned(), cause })?;
    parse_rays(&text).map_err(|(line, problem)| OutputError::Table { path: path.to_owned(), line, problem })
}

/// A line, from 1, and what is wrong with it.
type Fault = (usize, String);

fn parse_rays(text: &str) -> Result<Vec<[f64; 6]>, Fault> {
    let mut lines = text
        .trim_start_matches('\u{feff}')
        .lines()
        .enumerate()
        .map(|(i, line)| (i + 1, line))
        .filter(|(_, line)| !line.trim().is_empty());
    let expected = RAY_COLUMNS.join(",");
    let (line, header) = lines.next().ok_or_else(|| (1, format!("the file is empty; begin it with {expected}")))?;
    let order = column_order(header).map_err(|problem| (line, problem))?;
    let rays: Vec<_> =
        lines.map(|(line, row)| parse_ray(row, &order).map_err(|problem| (line, problem))).collect::<Result<_, _>>()?;
    if rays.is_empty() {
        return Err((line, "no rays follow the header; give one per line".into()));
    }
    Ok(rays)
}

/// For each column of the file, which of [`RAY_COLUMNS`] it is.
fn column_order(header: &str) -> Result<Vec<usize>, String> {
    let expected = RAY_COLUMNS.join(",");
    let mut order = Vec::new();
    for (i, name) in header.split(',').map(str::trim).enumerate() {
        let Some(column) = RAY_COLUMNS.iter().position(|c| *c == name) else {
            return Err(format!(
                "column {}: `{name}` is not a column of a rays file; the first line must name {expected}",
                i + 1
            ));
        };
        if order.contains(&column) {
            return Err(format!("column {}: `{name}` is named twice; keep one", i + 1));
        }
        order.push(column);
    }
    match (0..RAY_COLUMNS.len()).find(|column| !order.contains(column)) {
        Some(missing) => Err(format!(
            "the column `{}` is missing from `{}`; the first line must name {expected}",
            RAY_COLUMNS[missing],
            header.trim()
        )),
        None => Ok(order),
    }
}

fn parse_ray(row: &str, order: &[usize]) -> Result<[f64; 6], String> {
    let fields: Vec<_> = row.split(',').map(str::trim).collect();
    if fields.len() != order.len() {
        return Err(format!(
            "`{}` has {} fields; it must have {}, one for each column",
            row.trim(),
            fields.len(),
            order.len()
        ));
    }
    let mut ray = [0.0; 6];
    for (i, (field, &column)) in fields.iter().zip(order).enumerate() {
        ray[column] = match field.parse::<f64>() {
            Ok(value) if value.abs() <= 1e30 => value,
            _ => {
                return Err(format!(
                    "column {} ({}): `{field}` is not a finite number; write one such as 1.5 or -2e-3",
                    i + 1,
                    RAY_COLUMNS[column]
                ));
            }
        };
    }
    Ok(ray)
}

/// How one ray ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResultRow<'a> {
    /// Which ray, in the order of the input.
    pub ray: usize,
    /// The name of how it ended.
    pub status: &'a str,
    /// Where it ended, in scene coordinates.
    pub position: [f64; 3],
    /// Its velocity there.
    pub velocity: [f64; 3],
    /// The parameter along the ray.
    pub tau: f64,
    /// The depth there.
    pub depth: f64,
    /// Steps taken.
    pub steps: u32,
    /// Steps tried and thrown away.
    pub rejected: u32,
    /// The object hit, by its place in the scene file from 0; empty if there is none.
    pub object: Option<u32>,
}

/// One point on the path of a ray.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathRow {
    /// Which ray, in the order of the input.
    pub ray: usize,
    /// Which point of its path, from 0.
    pub index: usize,
    /// Where, in scene coordinates.
    pub position: [f64; 3],
    /// Its velocity there.
    pub velocity: [f64; 3],
    /// The parameter along the ray.
    pub tau: f64,
}

/// A table that can be written: its header, and a line for each row.
pub trait Row {
    /// The first line.
    const HEADER: &'static str;

    /// The fields of the row, with commas between them.
    fn line(&self) -> String;
}

impl Row for ResultRow<'_> {
    const HEADER: &'static str = "ray,status,x,y,z,vx,vy,vz,tau,depth,steps,rejected,object";

    fn line(&self) -> String {
        format!(
            "{},{},{},{},{},{},{},{},{}",
            self.ray,
            quoted(self.status),
            numbers(self.position),
            numbers(self.velocity),
            number(self.tau),
            number(self.depth),
            self.steps,
            self.rejected,
            self.object.map(|object| object.to_string()).unwrap_or_default()
        )
    }
}

impl Row for PathRow {
    const HEADER: &'static str = "ray,index,x,y,z,vx,vy,vz,tau";

    fn line(&self) -> String {
        format!(
            "{},{},{},{},{}",
            self.ray,
            self.index,
            numbers(self.position),
            numbers(self.velocity),
            number(self.tau)
        )
    }
}

/// A number in the shortest form that reads back as the same: as an f32 if that is what it is. `{:?}` rather than `{}`, which
/// would write 1e300 with all its zeros.
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

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

/// A table being written to a file, whole or not at all, or to standard output.
#[derive(Debug)]
pub struct Table {
    sink: Sink,
}

#[derive(Debug)]
enum Sink {
    File(AtomicFile),
    Stdout(BufWriter<Stdout>),
}

impl Table {
    /// Begins a table with the header of `R`; the path `-` is standard output.
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

    /// Appends a row, which should be of the kind the table was begun with.
    pub fn write<R: Row>(&mut self, row: &R) -> Result<(), OutputError> {
        self.line(&row.line())
    }

    /// Puts the file in place, or flushes standard output.
    pub fn finish(self) -> Result<(), OutputError> {
        match self.sink {
            Sink::File(file) => file.finish(),
            Sink::Stdout(mut out) => out.flush().map_err(stdout_error),
        }
    }

    fn line(&mut self, line: &str) -> Result<(), OutputError> {
        match &mut self.sink {
            Sink::File(file) => writeln!(file, "{line}").map_err(|e| file.failed(e)),
            Sink::Stdout(out) => writeln!(out, "{line}").map_err(stdout_error),
        }
    }
}

fn stdout_error(cause: io::Error) -> OutputError {
    OutputError::Write { path: "standard output".into(), cause }
}
