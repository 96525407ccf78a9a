//! The conversion of text, addresses and table rows to HTML.

use std::fmt::Write as _;
use std::path::Path;

/// Escapes text for an element or a quoted attribute.
///
/// Control characters, which HTML does not allow, become the replacement character.
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

/// Returns the URL of a relative path, which never refers to another host.
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

/// Returns a row of cells, one per column, with numbers marked.
pub(super) fn row(cell: &str, fields: &[String], numeric: &[bool]) -> String {
    let mut row = String::from("<tr>");
    for (i, numeric) in numeric.iter().enumerate() {
        let class = if *numeric { " class=\"number\"" } else { "" };
        let text = escape(fields.get(i).map_or("", String::as_str));
        let _ = write!(row, "<{cell}{class}>{text}</{cell}>"); // writing to a String cannot fail
    }
    row + "</tr>\n"
}
