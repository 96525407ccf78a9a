//! Text, addresses and rows of tables as HTML.

use std::fmt::Write as _;
use std::path::Path;

/// Text that shows as it is, in an element or in a quoted attribute.
///
/// Control characters, which a page may not hold, become the replacement character.
pub(super) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            c if c.is_control() && !matches!(c, '\n' | '\t') => escaped.push(char::REPLACEMENT_CHARACTER),
            c => escaped.push(c),
        }
    }
    escaped
}

/// A relative path as an address, which is never one of another place.
pub(super) fn address(path: &Path) -> String {
    let parts: Vec<_> = path.iter().map(|part| percent_encoded(&part.to_string_lossy())).collect();
    parts.join("/")
}

fn percent_encoded(part: &str) -> String {
    part.bytes()
        .map(|byte| match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' => char::from(byte).to_string(),
            _ => format!("%{byte:02X}"),
        })
        .collect()
}

/// A row of cells, as many as there are columns; those of numbers are marked.
pub(super) fn row(cell: &str, fields: &[String], numeric: &[bool]) -> String {
    let mut row = String::from("<tr>");
    for (i, numeric) in numeric.iter().enumerate() {
        let class = if *numeric { " class=\"number\"" } else { "" };
        let text = escape(fields.get(i).map_or("", String::as_str));
        let _ = write!(row, "<{cell}{class}>{text}</{cell}>"); // writing to a String cannot fail
    }
    row + "</tr>\n"
}
