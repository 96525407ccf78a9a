//! Tests of pages and text tables.

use std::{fs, path::PathBuf};

use proptest::prelude::*;

use super::{folder, names};
use crate::output::report::{ReportTable, Section, text_table, write_report};

fn strings(texts: &[&str]) -> Vec<String> {
    texts.iter().map(ToString::to_string).collect()
}

fn page(title: &str, sections: &[Section]) -> String {
    let folder = folder();
    let path = folder.path().join("index.html");
    write_report(&path, title, sections).unwrap();
    assert_eq!(names(folder.path()), [PathBuf::from("index.html")]);
    fs::read_to_string(path).unwrap()
}

/// Returns a report in which every text contains this one.
fn example(text: &str) -> Vec<Section> {
    let table = ReportTable {
        caption: format!("caption {text}"),
        header: strings(&["method", text]),
        rows: vec![vec![text.into(), "1.5".into()], strings(&["RK4"])],
    };
    let section = Section {
        title: format!("title {text}"),
        intro: strings(&[text, "more"]),
        images: vec![(PathBuf::from("plots").join("a.svg"), format!("alt {text}"))],
        tables: vec![table],
    };
    vec![section.clone(), section]
}

#[test]
fn a_page_stands_alone() {
    let html = page("Black holes & lenses", &example("< 5 M"));
    for part in [
        "<!DOCTYPE html>",
        "<title>Black holes &amp; lenses</title>",
        "<h2>title &lt; 5 M</h2>",
        "<p>more</p>",
        "<img src=\"plots/a.svg\" alt=\"alt &lt; 5 M\">",
        "<caption>caption &lt; 5 M</caption>",
        "<th class=\"number\">&lt; 5 M</th>",
        "<td class=\"number\">1.5</td>",
        "<tr><td>RK4</td><td class=\"number\"></td></tr>",
        "<a href=\"#part2\">",
        "<section id=\"part2\">",
    ] {
        assert!(html.contains(part), "{part}\n{html}");
    }
    for foreign in ["<script", "http", "url(", "@import", "<link"] {
        assert!(!html.contains(foreign), "{foreign}");
    }
}

#[test]
fn pictures_are_found_beside_the_page_only() {
    for (path, address) in [
        ("a b/ü#1.svg", "a%20b/%C3%BC%231.svg"),
        ("javascript:alert(1).svg", "javascript%3Aalert%281%29.svg"),
        ("http://example.org/a.svg", "http%3A/example.org/a.svg"),
        ("\"><b>.svg", "%22%3E%3Cb%3E.svg"),
    ] {
        let section = Section { images: vec![(path.into(), String::new())], ..Section::default() };
        let html = page("", &[section]);
        assert!(html.contains(&format!("<img src=\"{address}\" alt=\"\">")), "{html}");
    }
}

#[test]
fn a_table_is_aligned() {
    let header = strings(&["method", "error", "time", "front"]);
    let rows = [
        strings(&["Störmer–Verlet", "1.2e-7", "12.5 ns", "yes"]),
        strings(&["RK4", "-3e-10", "≈ 1234 ns", ""]),
        strings(&["two\nlines", "–"]),
    ];
    let expected = "\
        method           error       time  front\n\
        --------------  ------  ---------  -----\n\
        Störmer–Verlet  1.2e-7    12.5 ns  yes\n\
        RK4             -3e-10  ≈ 1234 ns\n\
        two lines            –\n";
    assert_eq!(text_table(&header, &rows), expected);
    assert_eq!(text_table(&[], &[]), "\n\n");
}

/// Returns every `<…>` of a page.
fn tags(html: &str) -> Vec<&str> {
    html.split('<').skip(1).map(|rest| rest.split('>').next().unwrap()).filter(|tag| !tag.contains("alt=")).collect()
}

fn unescaped(html: &str) -> String {
    [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&amp;", "&")]
        .into_iter()
        .fold(html.to_owned(), |text, (escape, c)| text.replace(escape, c))
}

fn cell() -> impl Strategy<Value = String> {
    prop_oneof!["[a-z<&\"' ü]{0,8}", "-?[0-9]{1,4}(\\.[0-9])?( ns)?", Just(String::new())]
}

proptest! {
    #[test]
    fn text_stays_text(text in "[a-z<>&\"'/=;! ü]{0,30}") {
        let html = page(&text, &example(&format!("x{text}")));
        let plain = page("", &example("x"));
        prop_assert_eq!(tags(&html), tags(&plain));
        let whole = unescaped(&html);
        for part in [format!("<title>{text}</title>"), format!("<p>x{text}</p>"), format!("alt=\"alt x{text}\"")] {
            prop_assert!(whole.contains(&part), "{part}");
        }
    }

    #[test]
    fn columns_stand_under_each_other(rows in prop::collection::vec(prop::collection::vec(cell(), 3), 1..6)) {
        let header = strings(&["first", "second", "third"]);
        let table = text_table(&header, &rows);
        let lines: Vec<Vec<char>> = table.lines().map(|line| line.chars().collect()).collect();
        prop_assert_eq!(lines.len(), rows.len() + 2);
        // The rule shows the position of the columns.
        let rule: String = lines[1].iter().collect();
        let mut start = 0;
        for (column, dashes) in rule.split("  ").enumerate() {
            let range = start..start + dashes.len();
            for (line, row) in lines[2..].iter().zip(&rows) {
                let shown: String = line.iter().skip(range.start).take(range.len()).collect();
                let words: Vec<_> = row[column].split_whitespace().collect();
                prop_assert_eq!(shown.trim(), words.join(" "));
                let after: String = line.iter().skip(range.end).take(2).collect();
                prop_assert!(after.trim().is_empty());
            }
            start = range.end + 2;
        }
    }
}
