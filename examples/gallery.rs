//! Renders every figure of the scene pages into a folder, and writes a page that shows each figure with its command and time.
//!
//! `cargo run --release --example gallery -- PROGRAM OUT [MORE...]`: `PROGRAM` is the `bentray` to run, and `MORE` is added to each render,
//! such as `--size 100x100`. The command of a figure is an indented line of a page that begins with `bentray`; the paragraph above it
//! describes the figure.

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// The folders below `scenes` that have a page.
const PAGES: [&str; 4] = ["spacetimes", "thesis", "groller", "paths"];

/// A command of a page, with its description.
struct Figure {
    about: String,
    line: String,
    words: Vec<String>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let (Some(program), Some(out)) = (words.next(), words.next()) else {
        return Err("usage: gallery PROGRAM OUT [MORE...]".into());
    };
    let (program, more) = (fs::canonicalize(program)?, words.collect::<Vec<_>>());
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    fs::create_dir_all(&out)?;
    let out = fs::canonicalize(out)?;
    let mut page = String::from(HEAD);
    for name in PAGES {
        let (folder, into) = (scenes.join(name), out.join(name));
        fs::create_dir_all(&into)?;
        let text = fs::read_to_string(folder.join("README.md"))?;
        let title = text.lines().next().unwrap_or(name).trim_start_matches("# ");
        writeln!(page, "<h2>{}</h2>\n<div>", escaped(title))?;
        for figure in figures(&text) {
            println!("bentray {}", figure.line);
            let (files, seconds) = run(&program, &folder, &into, &figure, &more)?;
            show(&mut page, &figure, name, &files, seconds)?;
        }
        page += "</div>\n";
    }
    fs::write(out.join("index.html"), page + "</body>\n</html>\n")?;
    println!("open {}", out.join("index.html").display());
    Ok(())
}

/// Returns the commands of a page, each with the paragraph above it.
fn figures(text: &str) -> Vec<Figure> {
    let mut about = String::new();
    let mut found = Vec::new();
    for paragraph in text.split("\n\n") {
        let lines = paragraph.lines().filter_map(|line| line.strip_prefix("    bentray "));
        let here: Vec<String> = lines.map(str::to_owned).collect();
        if here.is_empty() {
            about = paragraph.replace('\n', " ");
        }
        for line in here {
            let words = shlex::split(&line).unwrap_or_default();
            found.push(Figure { about: std::mem::take(&mut about), line, words });
        }
    }
    found
}

/// Runs a command in the folder of its page, and returns the files that it wrote and the time that it took, in seconds.
fn run(
    program: &Path,
    folder: &Path,
    into: &Path,
    figure: &Figure,
    more: &[String],
) -> Result<(Vec<PathBuf>, f64), Box<dyn Error>> {
    let mut files = Vec::new();
    let mut command = Command::new(program);
    let mut is_file = false;
    for word in &figure.words {
        if is_file {
            files.push(into.join(word));
            command.arg(into.join(word));
        } else {
            command.arg(word);
        }
        is_file = word == "-o" || word == "--plot";
    }
    if figure.words[0] == "render" {
        command.args(more);
    }
    let begun = Instant::now();
    let output = command.current_dir(folder).output()?;
    if !output.status.success() {
        return Err(format!("bentray {}: {}", figure.line, String::from_utf8_lossy(&output.stderr)).into());
    }
    Ok((files, begun.elapsed().as_secs_f64()))
}

fn show(page: &mut String, figure: &Figure, name: &str, files: &[PathBuf], seconds: f64) -> std::fmt::Result {
    writeln!(page, "<figure>")?;
    for file in files {
        let own = file.file_name().unwrap_or_default().to_string_lossy();
        // The frames of an animation are many files with one name pattern; the page shows the first.
        let (first, own) = (own.replace("{frame:2}", "00").replace("{frame}", "0"), escaped(&own));
        let address = format!("{name}/{}", escaped(&first));
        let is_shown = [".png", ".svg", ".gif"].iter().any(|end| first.ends_with(end));
        if is_shown {
            writeln!(page, "<a href=\"{address}\"><img src=\"{address}\" alt=\"{own}\" loading=\"lazy\"></a>")?;
        } else {
            writeln!(page, "<a href=\"{address}\">{own}</a>")?;
        }
    }
    let (about, line) = (escaped(&figure.about), escaped(&figure.line));
    writeln!(page, "<figcaption>{about} <code>bentray {line}</code> {seconds:.1} s</figcaption>\n</figure>")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

const HEAD: &str = "<!DOCTYPE html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width\">
<title>bentray: gallery</title>
<style>
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 80em; padding: 0 1em; }
div { display: grid; grid-template-columns: repeat(auto-fill, minmax(20em, 1fr)); gap: 1.5em; }
figure { margin: 0; }
img { width: 100%; background: #eee; }
code { font-size: 12px; background: #f3f3f3; overflow-wrap: anywhere; }
</style>
</head>
<body>
<h1>Gallery</h1>
<p>Each image with the command that renders it, run in the folder of its scenes, and its render time on this machine.</p>
";
