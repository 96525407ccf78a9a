//! Pages that show plots next to their tables ([`write_report`]), and the tables for a terminal ([`text_table`]).
//!
//! The page is one HTML file with its style: it has no scripts, and refers only to the plots, by relative paths. All input is text and is
//! shown literally, whatever characters it contains.

mod html;
mod text;

use std::{
    fmt::Write as _,
    path::{Path, PathBuf},
};

use self::html::{address, escape};
use super::{AtomicFile, OutputError};

pub use text::text_table;

const STYLE: &str = include_str!("style.css");

/// A section of a report.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Section {
    /// The title above the section.
    pub title: String,
    /// The paragraphs of the introduction.
    pub intro: Vec<String>,
    /// The images by their paths relative to the page, with their descriptions.
    pub images: Vec<(PathBuf, String)>,
    /// The tables, below the images.
    pub tables: Vec<ReportTable>,
}

/// A table of a report.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReportTable {
    /// The caption above the table; may be empty.
    pub caption: String,
    /// The names of the columns.
    pub header: Vec<String>,
    /// The rows; a shorter row ends in empty cells.
    pub rows: Vec<Vec<String>>,
}

/// Writes a report at `path`, as one page of HTML.
///
/// # Errors
///
/// Returns an error if the file cannot be created or written.
pub fn write_report(path: &Path, title: &str, sections: &[Section]) -> Result<(), OutputError> {
    AtomicFile::write_whole(path, page(title, sections).as_bytes())
}

fn page(title: &str, sections: &[Section]) -> String {
    let title = escape(title);
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
    );
    if sections.len() > 1 {
        contents(&mut page, sections);
    }
    for (i, part) in sections.iter().enumerate() {
        section(&mut page, i + 1, part);
    }
    page.push_str("</body>\n</html>\n");
    page
}

// Writing to a String cannot fail.

fn contents(page: &mut String, sections: &[Section]) {
    page.push_str("<nav>\n<ol>\n");
    for (i, section) in sections.iter().enumerate() {
        let _ = writeln!(page, "<li><a href=\"#part{}\">{}</a></li>", i + 1, escape(&section.title));
    }
    page.push_str("</ol>\n</nav>\n");
}

fn section(page: &mut String, number: usize, section: &Section) {
    let _ = writeln!(page, "<section id=\"part{number}\">\n<h2>{}</h2>", escape(&section.title));
    for paragraph in &section.intro {
        let _ = writeln!(page, "<p>{}</p>", escape(paragraph));
    }
    for (path, alt) in &section.images {
        let _ = writeln!(page, "<figure><img src=\"{}\" alt=\"{}\"></figure>", address(path), escape(alt));
    }
    for table in &section.tables {
        write_table(page, table);
    }
    page.push_str("</section>\n");
}

fn write_table(page: &mut String, table: &ReportTable) {
    page.push_str("<table>\n");
    if !table.caption.is_empty() {
        let _ = writeln!(page, "<caption>{}</caption>", escape(&table.caption));
    }
    let numeric = text::number_columns(&table.header, &table.rows);
    let _ = writeln!(page, "<thead>\n{}</thead>\n<tbody>", html::row("th", &table.header, &numeric));
    for row in &table.rows {
        page.push_str(&html::row("td", row, &numeric));
    }
    page.push_str("</tbody>\n</table>\n");
}
