//! Builds the web site of the manual with mdBook, from the folder that the example `manual` wrote, and checks its links.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use mdbook_driver::MDBook;
use mdbook_driver::config::Config;

type Outcome<T> = Result<T, Box<dyn Error>>;

const CONFIG: &str = r#"
[book]
title = "bentray"
language = "en"
src = "src"
[build]
build-dir = "html"
create-missing = false
[output.html]
default-theme = "light"
additional-css = ["manual.css"]
no-section-label = true
[output.html.search]
limit-results = 20
[output.html.fold]
enable = true
level = 0
"#;

fn main() -> Outcome<()> {
    let folder = std::env::args().nth(1).ok_or("usage: site FOLDER")?;
    let folder = Path::new(&folder);
    fs::write(folder.join("manual.css"), include_str!("../manual.css"))?;
    MDBook::load_with_config(folder, CONFIG.parse::<Config>()?)?.build()?;
    let (pages, links) = check_links(&folder.join("html"))?;
    println!("{pages} pages with {links} links: open {}", folder.join("html/index.html").display());
    Ok(())
}

/// Checks that every link and picture of the site leads to a file of the site, and returns the number of pages and of links.
fn check_links(site: &Path) -> Outcome<(usize, usize)> {
    let pages = html_in(site)?;
    let (mut count, mut broken) = (0, Vec::new());
    for page in &pages {
        let text = fs::read_to_string(page)?;
        let folder = page.parent().unwrap_or(site);
        for attribute in ["href=\"", "src=\""] {
            for target in text.split(attribute).skip(1).filter_map(|rest| rest.split('"').next()) {
                let file = target.split(['#', '?']).next().unwrap_or(target);
                if file.is_empty() || target.contains(':') {
                    continue;
                }
                count += 1;
                if !folder.join(file).exists() {
                    broken.push(format!("{}: {target}", page.display()));
                }
            }
        }
    }
    if broken.is_empty() { Ok((pages.len(), count)) } else { Err(broken.join("\n").into()) }
}

fn html_in(folder: &Path) -> Outcome<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            found.extend(html_in(&path)?);
        } else if path.extension().is_some_and(|ending| ending == "html") {
            found.push(path);
        }
    }
    Ok(found)
}
