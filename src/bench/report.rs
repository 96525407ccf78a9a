//! The result of a measurement, for people and for scripts.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::output::plot::{Chart, plot_lines};
use crate::output::report::{ReportTable, Section, text_table};
use crate::output::{AtomicFile, OutputError};

/// An entry of a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A text.
    Text(String),
    /// A number, in the column's unit.
    Number(f64),
    /// A missing measurement.
    None,
}

impl Cell {
    fn text(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Number(number) => rounded(*number),
            Self::None => String::new(),
        }
    }

    fn csv(&self) -> String {
        match self {
            Self::Text(text) => format!("\"{}\"", text.replace('"', "\"\"")),
            Self::Number(number) => format!("{number:e}"),
            Self::None => String::new(),
        }
    }

    fn json(&self) -> Value {
        match self {
            Self::Text(text) => json!(text),
            Self::Number(number) => json!(number),
            Self::None => Value::Null,
        }
    }
}

/// Rounds to four digits, which exceeds the agreement of repeats.
fn rounded(number: f64) -> String {
    if number == 0.0 || !number.is_finite() {
        return number.to_string();
    }
    let digits = 3 - number.abs().log10().floor() as i32;
    if (-3..=6).contains(&digits) { format!("{number:.*}", digits.max(0) as usize) } else { format!("{number:.3e}") }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<f64> for Cell {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<u32> for Cell {
    fn from(number: u32) -> Self {
        Self::Number(number.into())
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(some: Option<T>) -> Self {
        some.map_or(Self::None, Into::into)
    }
}

/// A table of a report.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// The name in file names and JSON.
    pub name: &'static str,
    /// The caption.
    pub caption: String,
    /// The names of the columns, with units.
    pub header: Vec<String>,
    /// The rows, each with a cell for every column.
    pub rows: Vec<Vec<Cell>>,
}

impl Table {
    /// Creates a table without rows; `header` contains the columns' names separated by ` | `.
    #[must_use]
    pub fn new(name: &'static str, caption: impl Into<String>, header: &str) -> Self {
        let header = header.split(" | ").map(str::to_owned).collect();
        Self { name, caption: caption.into(), header, rows: Vec::new() }
    }

    /// Appends a row of words followed by numbers.
    pub fn row(&mut self, words: &[&str], numbers: impl IntoIterator<Item = impl Into<Cell>>) {
        let words = words.iter().map(|word| Cell::from(*word));
        self.rows.push(words.chain(numbers.into_iter().map(Into::into)).collect());
    }

    fn texts(&self) -> Vec<Vec<String>> {
        self.rows.iter().map(|row| row.iter().map(Cell::text).collect()).collect()
    }

    fn csv(&self) -> String {
        let header: Vec<String> = self.header.iter().map(|name| Cell::from(name.as_str()).csv()).collect();
        let rows = self.rows.iter().map(|row| row.iter().map(Cell::csv).collect::<Vec<_>>().join(","));
        std::iter::once(header.join(",")).chain(rows).map(|line| line + "\n").collect()
    }

    fn json(&self) -> Value {
        let object = |row: &Vec<Cell>| self.header.iter().cloned().zip(row.iter().map(Cell::json)).collect();
        Value::Array(self.rows.iter().map(|row| Value::Object(object(row))).collect())
    }
}

/// The result of a measurement.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// The name on the command line and in file names.
    pub name: &'static str,
    /// The title.
    pub title: String,
    /// The description of the measurement.
    pub intro: Vec<String>,
    /// The tables.
    pub tables: Vec<Table>,
    /// The plots, each with its name in file names.
    pub plots: Vec<(&'static str, Chart)>,
}

impl Report {
    /// Returns the report as text for a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        let tables = self.tables.iter().map(|t| format!("\n{}\n{}", t.caption, text_table(&t.header, &t.texts())));
        std::iter::once(format!("{}\n", self.title)).chain(tables).collect()
    }

    /// Returns JSON for scripts: name and title, and the tables by name, each a list of rows by column.
    #[must_use]
    pub fn json(&self) -> Value {
        let tables: serde_json::Map<_, _> = self.tables.iter().map(|t| (t.name.to_owned(), t.json())).collect();
        json!({ "name": self.name, "title": self.title, "tables": tables })
    }

    /// Writes every table as CSV and every plot as SVG and PNG into `folder`, and returns the page's section.
    ///
    /// # Errors
    ///
    /// Returns an error if a file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<Section, OutputError> {
        let mut images = Vec::new();
        for table in &self.tables {
            AtomicFile::write_whole(&folder.join(format!("{}_{}.csv", self.name, table.name)), table.csv().as_bytes())?;
        }
        for (name, chart) in &self.plots {
            for format in ["svg", "png"] {
                plot_lines(&folder.join(format!("{}_{name}.{format}", self.name)), chart)?;
            }
            images.push((PathBuf::from(format!("{}_{name}.svg", self.name)), chart.title.clone()));
        }
        let table = |t: &Table| ReportTable { caption: t.caption.clone(), header: t.header.clone(), rows: t.texts() };
        Ok(Section {
            title: self.title.clone(),
            intro: self.intro.clone(),
            images,
            tables: self.tables.iter().map(table).collect(),
        })
    }
}
