//! Tables as aligned text.

/// Returns a table as lines of text: the header, a rule and the rows, with two spaces between the columns.
///
/// Columns that contain only numbers are right-aligned, others left-aligned. A cell stays on one line, and no line ends in spaces.
#[must_use]
pub fn text_table(header: &[String], rows: &[Vec<String>]) -> String {
    let numeric = number_columns(header, rows);
    let header: Vec<_> = header.iter().map(|cell| one_line(cell)).collect();
    let rows: Vec<Vec<_>> = rows.iter().map(|row| row.iter().map(|cell| one_line(cell)).collect()).collect();
    let columns: Vec<_> =
        numeric.into_iter().enumerate().map(|(i, right)| (widest(&header, &rows, i), right)).collect();
    let rule: Vec<_> = columns.iter().map(|(width, _)| "-".repeat(*width)).collect();
    [&header, &rule].into_iter().chain(&rows).map(|row| line(row, &columns)).collect()
}

/// Returns `true` for each column that contains numbers and nothing else.
pub(super) fn number_columns(header: &[String], rows: &[Vec<String>]) -> Vec<bool> {
    let columns = rows.iter().map(Vec::len).chain([header.len()]).max().unwrap_or(0);
    (0..columns)
        .map(|i| {
            let mut cells =
                rows.iter().filter_map(|row| row.get(i).map(|cell| cell.trim())).filter(|c| !is_blank(c)).peekable();
            cells.peek().is_some() && cells.all(is_number)
        })
        .collect()
}

/// Returns `true` if a cell has no value.
fn is_blank(cell: &str) -> bool {
    matches!(cell, "" | "-" | "–" | "—")
}

/// Returns `true` if a cell is a number, optionally with a comparison before it or a unit after it.
fn is_number(cell: &str) -> bool {
    let mut words = cell.trim_start_matches(['<', '>', '≤', '≥', '~', '≈', ' ']).split_whitespace();
    let number = words
        .next()
        .is_some_and(|word| word.trim_end_matches(['%', '×', 'x']).replace('−', "-").parse::<f64>().is_ok());
    number && words.nth(1).is_none()
}

fn widest(header: &[String], rows: &[Vec<String>], column: usize) -> usize {
    let all = rows.iter().map(Vec::as_slice).chain([header]);
    let cells = all.filter_map(|row| row.get(column)).map(|cell| width(cell)).max();
    cells.unwrap_or(0)
}

/// Returns a row with its cells padded to their width; `true` in `columns` means right-aligned.
fn line(row: &[String], columns: &[(usize, bool)]) -> String {
    let mut line = String::new();
    for (i, (column, right)) in columns.iter().enumerate() {
        let cell = row.get(i).map_or("", String::as_str);
        let padding = " ".repeat(column - width(cell));
        let gap = if i == 0 { "" } else { "  " };
        let [first, second] = if *right { [padding.as_str(), cell] } else { [cell, padding.as_str()] };
        line.extend([gap, first, second]);
    }
    format!("{}\n", line.trim_end())
}

fn width(cell: &str) -> usize {
    cell.chars().count()
}

/// Returns a cell without line breaks and outer spaces.
fn one_line(cell: &str) -> String {
    cell.split_whitespace().collect::<Vec<_>>().join(" ")
}
