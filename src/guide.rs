//! The manual, as `bentray help` prints it.
//!
//! *Idea.* The pages are the Markdown files in `manual/pages`, in the order of `manual/SUMMARY.md`. `make manual` turns the same files
//! into a web site.

use std::fmt::Write;

use include_dir::{Dir, include_dir};

static PAGES: Dir = include_dir!("$CARGO_MANIFEST_DIR/manual/pages");
const SUMMARY: &str = include_str!("../manual/SUMMARY.md");

/// A page of the manual.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Page {
    /// The part of the manual that the page belongs to, such as `Tutorials`; empty for the introduction.
    pub part: &'static str,
    /// The topic for `bentray help`, which is the file name of the page without its extension.
    pub name: &'static str,
    /// The title of the page.
    pub title: &'static str,
    /// The path of the page's file below `manual`.
    pub path: &'static str,
    /// The page in Markdown.
    pub text: &'static str,
}

/// Returns every page of the manual, in reading order.
pub fn pages() -> impl Iterator<Item = Page> {
    let mut part = "";
    SUMMARY.lines().filter_map(move |line| {
        if let Some(title) = line.strip_prefix("# ") {
            part = title;
        }
        let (title, path) = line.split_once('[')?.1.strip_suffix(')')?.split_once("](")?;
        let file = PAGES.get_file(path.strip_prefix("pages/")?)?;
        let name = file.path().file_stem()?.to_str()?;
        Some(Page { part, name, title, path, text: file.contents_utf8()? })
    })
}

impl Page {
    /// Returns the arguments of each `bentray` command in the page's `sh` blocks.
    #[must_use]
    pub fn commands(self) -> Vec<Vec<String>> {
        let lines = blocks(self.text, "sh").into_iter().flat_map(str::lines);
        lines.filter_map(|line| shlex::split(line.strip_prefix("bentray ")?)).collect()
    }

    /// Returns the files that the page has the reader create, as names and contents: the blocks whose first line is a comment with a
    /// file name.
    #[must_use]
    pub fn files(self) -> Vec<(&'static str, &'static str)> {
        let all = ["toml", "csv", "wgsl"].into_iter().flat_map(|language| blocks(self.text, language));
        let named = all.filter_map(|text| {
            let (first, rest) = text.split_once('\n')?;
            let name = first.strip_prefix("# ").or(first.strip_prefix("// "))?;
            let is_name =
                name.contains('.') && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"._-".contains(&byte));
            // A table has no comments.
            is_name.then_some((name, if name.rsplit('.').next() == Some("csv") { rest } else { text }))
        });
        named.collect()
    }

    /// Returns the page as a terminal shows it: a link to another page becomes the command that prints that page, and a picture its
    /// description.
    #[must_use]
    pub fn shown(self) -> String {
        let mut shown = String::new();
        let mut rest = self.text;
        let mut is_code = false;
        while let Some((before, text, target, after)) = next_link(rest) {
            is_code ^= before.matches("```").count() % 2 == 1;
            if is_code {
                // Brackets and parentheses of a program are not a link.
                let end = before.len() + 1;
                shown += &rest[..end];
                rest = &rest[end..];
                continue;
            }
            let (before, is_picture) = before.strip_suffix('!').map_or((before, false), |before| (before, true));
            shown += before;
            let page = target.split('#').next().unwrap_or(target);
            let name = page.strip_suffix(".md").and_then(|page| page.rsplit('/').next());
            // Writing to a string cannot fail.
            let _ = match name {
                _ if is_picture => write!(shown, "[picture: {text}]"),
                Some(name) if pages().any(|page| page.name == name) => write!(shown, "{text} (`bentray help {name}`)"),
                _ if target.starts_with('#') => write!(shown, "{text}"),
                _ => write!(shown, "{text} ({})", target.trim_start_matches("../")),
            };
            rest = after;
        }
        shown + rest
    }
}

/// Returns the first inline link of a Markdown text: the text before it, its own text, its target, and the text after it.
fn next_link(text: &str) -> Option<(&str, &str, &str, &str)> {
    let middle = text.find("](")?;
    let start = text[..middle].rfind('[')?;
    let end = middle + text[middle..].find(')')?;
    Some((&text[..start], &text[start + 1..middle], &text[middle + 2..end], &text[end + 1..]))
}

/// Returns the code blocks of a Markdown text in this language.
#[must_use]
pub fn blocks<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let fenced = text.split("```").skip(1).step_by(2);
    fenced.filter_map(|block| block.strip_prefix(language)?.strip_prefix('\n')).collect()
}

/// The pages whose Rust code is compiled with the documentation tests.
#[cfg(doctest)]
mod with_code {
    #[doc = include_str!("../manual/pages/guide/extending.md")]
    mod extending {}
    #[doc = include_str!("../manual/pages/recipes/rust_render.md")]
    mod rust_render {}
}
