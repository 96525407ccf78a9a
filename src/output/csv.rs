//! The input tables of rays and positions, as plain CSV.
//!
//! The first line lists the columns. Empty lines and comments, which begin with `#`, are skipped. The whole file is stored, about 100 bytes
//! per ray.

use std::path::Path;

use super::OutputError;
use super::table::number;
use crate::document::{SceneError, given_name, read_given, strict_text};

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
        let problem = || {
            format!(
                "the velocity {} has no direction; use a nonzero vector such as 0,0,-1",
                [*x, *y, *z].map(number).join(",")
            )
        };
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
