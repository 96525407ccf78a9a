//! Every link on every page has a target, as a viewer of plain Markdown reads it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use pulldown_cmark::{BrokenLink, Event, Parser, Tag, TagEnd};

fn pages(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in folder.read_dir().unwrap().map(|entry| entry.unwrap().path()) {
        if entry.is_dir() {
            pages(&entry, found);
        } else if entry.extension().is_some_and(|extension| extension == "md") {
            found.push(entry);
        }
    }
}

/// The links of a page, and the possible targets in it.
#[derive(Default)]
pub struct Links {
    pub targets: Vec<String>,
    anchors: BTreeSet<String>,
    /// References without a definition: a viewer shows their brackets.
    undefined: Vec<String>,
}

pub fn links(text: &str) -> Links {
    let mut found = Links::default();
    let mut undefined = Vec::new();
    let mut heading: Option<String> = None;
    // Numbers in brackets are intervals and lists.
    let is_word = |c: char| c.is_alphanumeric() || "`_' -".contains(c);
    let note = |broken: BrokenLink| {
        let reference = broken.reference.to_string();
        if reference.contains(|c: char| c.is_alphabetic()) && reference.chars().all(is_word) {
            undefined.push(reference);
        }
        None
    };
    for event in Parser::new_with_broken_link_callback(text, pulldown_cmark::Options::ENABLE_TABLES, Some(note)) {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => {
                found.anchors.extend(heading.take().map(|heading| anchor(&heading)));
            }
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                found.targets.push(dest_url.to_string());
            }
            Event::Text(words) | Event::Code(words) => {
                if let Some(heading) = &mut heading {
                    *heading += &words;
                }
            }
            _ => {}
        }
    }
    found.undefined = undefined;
    found
}

/// Returns the anchor of a heading as GitHub and rustdoc make it.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

#[test]
fn every_link_leads_somewhere() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = vec![root.join("README.md"), root.join("CONTRIBUTING.md")];
    for folder in ["manual", "scenes", "shaders"] {
        pages(&root.join(folder), &mut files);
    }
    let read = |path: &PathBuf| (path.canonicalize().unwrap(), links(&std::fs::read_to_string(path).unwrap()));
    let all: BTreeMap<PathBuf, Links> = files.iter().map(read).collect();
    let mut wrong = Vec::new();
    let mut count = 0;
    for (path, page) in &all {
        let name = path.strip_prefix(root.canonicalize().unwrap()).unwrap().display();
        wrong.extend(page.undefined.iter().map(|reference| format!("{name}: [{reference}] is defined nowhere")));
        for target in page.targets.iter().filter(|target| !target.contains("://")) {
            count += 1;
            let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
            let file = if file.is_empty() { path.clone() } else { path.parent().unwrap().join(file) };
            let has = |anchor: &str| {
                let page = file.canonicalize().ok().and_then(|file| all.get(&file));
                page.is_some_and(|page| page.anchors.contains(anchor))
            };
            // These chapters of the manual are made when its site is built.
            let made = ["keys.md", "commands.md"].map(|name| format!("reference/{name}"));
            if made.iter().any(|made| file.ends_with(made)) || target.contains("reference/table_") {
                continue;
            }
            if !file.exists() || !anchor.is_empty() && !has(anchor) {
                wrong.push(format!("{name}: {target} leads nowhere"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(count > 80, "only {count} links were found");
}

#[test]
fn links_that_lead_nowhere_are_found() {
    let found =
        links("# A *b*: `c_d`, 2-e\n\n[x](y.md#z) [`w`] [0, 1] [`v`] ![p](q.png)\n\n```\n[`u`]\n```\n\n[`v`]: v.md\n");
    assert_eq!(found.targets, ["y.md#z", "v.md", "q.png"]);
    assert_eq!(found.undefined, ["`w`"]);
    assert!(found.anchors.contains("a-b-c_d-2-e"));
}
