//! Writes the source of the manual's web site, which `make manual` builds with mdBook: `cargo run --example manual -- PROGRAM OUT`.
//!
//! The pages are listed in `manual/SUMMARY.md`. Two chapters are made here: the keys of a scene file, from the reference of the format,
//! and the commands, from the help of `PROGRAM`. Every file that a page links to is copied to the place that it has in the repository, so
//! that links work in the site as they do there; a link that leads nowhere is an error.
//!
//! `cargo run --release --example manual -- PROGRAM OUT PAGE...` makes the pictures of these pages again, by their own commands, at full size.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::process::Command;

use bentray::document::KeyReference;
use bentray::guide::{Page, pages};
use bentray::scene::REFERENCE;

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [program, out, names @ ..] = words.as_slice() else { return Err("usage: manual PROGRAM OUT [PAGE...]".into()) };
    let program = fs::canonicalize(program)?;
    if !names.is_empty() {
        let is_named = |page: &Page| names.iter().any(|name| name == page.name);
        return pages().filter(is_named).try_for_each(|page| make_pictures(&program, page));
    }
    let out = Path::new(out);
    if out.exists() {
        fs::remove_dir_all(out)?;
    }
    let source = out.join("src");
    fs::create_dir_all(&source)?;
    let (keys, commands) = (key_pages(), command_page(&program)?);
    let summary = read("manual/SUMMARY.md")?;
    let mut book = Source { folder: source.clone(), copied: BTreeSet::new() };
    for path in summary.lines().filter_map(chapter) {
        match path.strip_prefix("manual/pages/reference/") {
            Some("keys.md") => keys.iter().try_for_each(|(path, text)| book.write(path, text))?,
            Some("commands.md") => book.write(&path, &commands)?,
            _ => book.add(&path)?,
        }
    }
    fs::write(source.join("SUMMARY.md"), with_tables(&summary, &keys))?;
    println!("{} pages", book.copied.len());
    Ok(())
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &str) -> Outcome<String> {
    fs::read_to_string(root().join(path)).map_err(|error| format!("{path}: {error}").into())
}

/// Returns the file of a chapter from its line in `SUMMARY.md`, relative to the repository.
fn chapter(line: &str) -> Option<String> {
    let path = line.split_once("](")?.1.strip_suffix(')')?;
    Some(joined(Path::new("manual"), path))
}

/// Returns the path from the repository to a file that is named relative to a folder.
fn joined(folder: &Path, path: &str) -> String {
    let mut joined = PathBuf::new();
    for part in folder.join(path).components() {
        match part {
            Component::ParentDir => _ = joined.pop(),
            Component::CurDir => {}
            part => joined.push(part),
        }
    }
    joined.display().to_string()
}

/// Returns the place of a page in the book, from its place in the repository: the first page is at the top, and mdBook calls the page of a
/// folder its index.
fn address(path: &str) -> String {
    path.replace("README.md", "index.md").replace("manual/pages/introduction.md", "index.md")
}

/// The source of the book: copies of pages and of the files that they link to.
struct Source {
    folder: PathBuf,
    copied: BTreeSet<String>,
}

impl Source {
    /// Writes a page, and copies the files that it links to.
    fn write(&mut self, path: &str, text: &str) -> Outcome<()> {
        self.copied.insert(path.to_owned());
        let folder = Path::new(path).parent().unwrap_or(Path::new(""));
        let to = address(path);
        let to_folder = Path::new(&to).parent().unwrap_or(Path::new(""));
        fs::create_dir_all(self.folder.join(to_folder))?;
        let mut text = text.to_owned();
        for target in links(&text) {
            if to_folder != folder && !target.contains("://") && !target.starts_with('#') {
                text = text.replace(&format!("]({target})"), &format!("]({})", address(&joined(folder, &target))));
            } else if target.contains("README.md") {
                text = text.replace(&format!("]({target})"), &format!("]({})", address(&target)));
            }
            let file = joined(folder, target.split('#').next().unwrap_or(&target));
            let is_page = Path::new(&file).extension() == Some("md".as_ref());
            let is_file = !target.contains("://") && !target.starts_with('#') && !is_page;
            if is_file && root().join(&file).is_file() {
                let to = self.folder.join(&file);
                fs::create_dir_all(to.parent().unwrap_or(&self.folder))?;
                fs::copy(root().join(&file), to)?;
            }
        }
        fs::write(self.folder.join(to), text)?;
        Ok(())
    }

    /// Adds a page of the repository. A picture that a command of a scene's page writes is shown below the command.
    fn add(&mut self, path: &str) -> Outcome<()> {
        let folder = root().join(path).parent().unwrap_or(root()).join("pictures");
        let mut text = String::new();
        for line in read(path)?.lines() {
            text.extend([line, "\n"]);
            let name = line.strip_prefix("    bentray ").and_then(|line| line.split(" -o ").nth(1)?.split(' ').next());
            let name = name.map(|name| name.replace(".exr", ".png"));
            if let Some(name) = name.filter(|name| folder.join(name).is_file()) {
                writeln!(text, "\n![The image of this command](pictures/{name})")?;
            }
        }
        self.write(path, &text)
    }
}

/// Returns the target of every inline link and picture of a Markdown text.
fn links(text: &str) -> Vec<String> {
    use pulldown_cmark::{Event, Parser, Tag};
    let target = |event| match event {
        Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => Some(dest_url.to_string()),
        _ => None,
    };
    Parser::new(text).filter_map(target).collect()
}

/// Lists the pages of the scene file's tables below its own.
fn with_tables(summary: &str, keys: &[(String, String)]) -> String {
    let mut text = String::new();
    for line in summary.lines() {
        let Some(path) = chapter(line) else {
            text.extend([line, "\n"]);
            continue;
        };
        let (before, _) = line.split_once("](").unwrap_or((line, ""));
        text.extend([before, "](", &address(&path), ")\n"]);
        if path.ends_with("/keys.md") {
            for (path, page) in &keys[1..] {
                let title = page.lines().next().unwrap_or("").trim_start_matches("# ");
                text.extend(["  - [", title, "](", path, ")\n"]);
            }
        }
    }
    text
}

/// Returns the pages of the reference: an overview, then a page for each table with its keys and a picture for each kind.
fn key_pages() -> Vec<(String, String)> {
    let pictures = pictures_of_kinds();
    let folder = "manual/pages/reference";
    let head =
        "# Scene file\n\nA scene is a TOML file. Each of its tables has a page here.\n\n| table | keys |\n|---|---|\n";
    let mut overview = head.to_owned();
    let mut found = Vec::new();
    for keys in REFERENCE.chunk_by(|a, b| a.table == b.table) {
        let table = keys[0].table;
        let title = if table.is_empty() { "Top level".to_owned() } else { format!("`[{table}]`") };
        let file = if table.is_empty() { "top_level".to_owned() } else { table.to_lowercase().replace('.', "_") };
        let names: BTreeSet<String> = keys.iter().map(|key| format!("`{}`", key.key)).collect();
        let names: Vec<String> = names.into_iter().collect();
        overview.extend(["| [", &title, "](table_", &file, ".md) | ", &names.join(", "), " |\n"]);
        let mut text = format!("# {title}\n\n| key | value | default | meaning |\n|---|---|---|---|\n");
        text.extend(keys.iter().map(key_row));
        let shown: Vec<_> = pictures.iter().filter(|((own, ..), _)| own == table).collect();
        if !shown.is_empty() {
            text += "\n## Pictures\n\n";
        }
        for ((_, key, value), picture) in shown {
            let Picture { file, source, .. } = picture;
            let link = format!("[{source}](../../../{source})");
            text.extend([
                "`",
                key,
                " = \"",
                value,
                "\"`, from ",
                &link,
                ":\n\n![",
                value,
                "](../../../",
                file,
                ")\n\n",
            ]);
        }
        found.push((format!("{folder}/table_{file}.md"), text));
    }
    found.insert(0, (format!("{folder}/keys.md"), overview));
    found
}

fn key_row(key: &KeyReference) -> String {
    let when = if key.when.is_empty() { String::new() } else { format!("With `{}`: ", key.when) };
    let cells = [&*key.value, key.default, &format!("{when}{}", key.meaning)].map(|cell| cell.replace('|', "\\|"));
    format!("| `{}` | {} |\n", key.key, cells.join(" | "))
}

/// A kind by its table, key and value.
type Kind = (String, String, String);

/// A picture of a scene.
#[derive(Clone)]
struct Picture {
    /// The picture's file in the repository.
    file: String,
    /// The scene file, or the page of the manual that has the scene.
    source: String,
    /// The scene in TOML.
    scene: String,
}

/// Returns a picture for each kind that a scene with a picture has: that of the shortest such scene.
fn pictures_of_kinds() -> BTreeMap<Kind, Picture> {
    let mut found: BTreeMap<Kind, Picture> = BTreeMap::new();
    for picture in pictures_of_scenes().into_iter().chain(pictures_of_pages()) {
        let Ok(value) = picture.scene.parse::<toml::Table>() else { continue };
        let mut kinds = BTreeSet::new();
        collect_kinds("", &toml::Value::Table(value), &mut kinds);
        for kind in kinds {
            let best = found.get(&kind).map_or(usize::MAX, |best| best.scene.len());
            if picture.scene.len() < best {
                found.insert(kind, picture.clone());
            }
        }
    }
    found
}

/// Returns the name of the PNG that a command renders of a scene as its file describes it: it changes no key that a kind depends on.
fn plain_render(words: &[String]) -> Option<&str> {
    let changes = words.iter().zip(&words[1..]).filter(|(flag, _)| *flag == "--set").map(|(_, change)| change);
    let is_plain = changes.into_iter().all(|change| !change.contains(['"', '{']) && !change.contains("kind"));
    let output = words.iter().zip(&words[1..]).find(|(flag, _)| *flag == "-o").map(|(_, file)| file)?;
    (words[0] == "render" && is_plain).then_some(output)
}

/// Returns the pictures of the scenes' pages.
fn pictures_of_scenes() -> Vec<Picture> {
    let mut found = Vec::new();
    for folder in ["spacetimes", "thesis", "groller", "paths"].map(|name| format!("scenes/{name}")) {
        let text = read(&format!("{folder}/README.md")).unwrap_or_default();
        for line in text.lines().filter_map(|line| line.strip_prefix("    bentray ")) {
            let words = shlex::split(line).unwrap_or_default();
            let Some(name) = plain_render(&words) else { continue };
            let (file, source) = (format!("{folder}/pictures/{name}"), format!("{folder}/{}", words[1]));
            if let (true, Ok(scene)) = (root().join(&file).is_file(), read(&source)) {
                found.push(Picture { file, source, scene });
            }
        }
    }
    found
}

/// Returns the pictures of the manual.
fn pictures_of_pages() -> Vec<Picture> {
    let mut found = Vec::new();
    for page in pages() {
        for words in page.commands() {
            let Some(stem) = plain_render(&words).and_then(|name| name.strip_suffix(".png")) else { continue };
            let file = format!("manual/pictures/{stem}.jpg");
            let own = page.files().into_iter().find(|(name, _)| *name == words[1]);
            let of_page = own.map(|(_, text)| (format!("manual/{}", page.path), text.to_owned()));
            let scene = of_page.or_else(|| read(&words[1]).ok().map(|text| (words[1].clone(), text)));
            if let (true, Some((source, scene))) = (root().join(&file).is_file(), scene) {
                found.push(Picture { file, source, scene });
            }
        }
    }
    found
}

fn collect_kinds(table: &str, value: &toml::Value, kinds: &mut BTreeSet<Kind>) {
    match value {
        toml::Value::Table(keys) => {
            for (key, value) in keys {
                let is_choice =
                    REFERENCE.iter().any(|row| row.table == table && row.key == key && row.value.contains(" | "));
                if let (true, toml::Value::String(value)) = (is_choice, value) {
                    kinds.insert((table.to_owned(), key.clone(), value.clone()));
                }
                // A medium and an absorption have one table in the reference, wherever they are in a scene.
                let below = match (table, &**key) {
                    (_, "interior" | "medium" | "index") => "medium".to_owned(),
                    (_, "absorption") => "absorption".to_owned(),
                    ("materials", _) => "materials.NAME".to_owned(),
                    ("", key) => key.to_owned(),
                    (table, key) => format!("{table}.{key}"),
                };
                collect_kinds(&below, value, kinds);
            }
        }
        toml::Value::Array(values) => values.iter().for_each(|value| collect_kinds(table, value, kinds)),
        _ => {}
    }
}

/// Returns the page of the commands: the help of each.
fn command_page(program: &Path) -> Outcome<String> {
    let help = |words: &[&str]| -> Outcome<String> {
        let output = Command::new(program).args(words).arg("--help").env("COLUMNS", "100").output()?;
        Ok(String::from_utf8(output.stdout)?.trim_end().to_owned())
    };
    let top = help(&[])?;
    let mut text = "# Commands\n\nEach section is the output of `bentray COMMAND --help`.\n\n".to_owned();
    let names = top.split("Commands:\n").nth(1).unwrap_or_default().split("\n\n").next().unwrap_or_default();
    let names = names
        .lines()
        .filter_map(|line| line.strip_prefix("  ").filter(|line| !line.starts_with(' '))?.split(' ').next());
    for name in names {
        write!(text, "## bentray {name}\n\n```text\n{}\n```\n\n", help(&[name])?)?;
    }
    Ok(text)
}

/// Returns the file of this name that commands wrote into a folder or into one of its subfolders.
fn made(folder: &Path, name: &str) -> Outcome<PathBuf> {
    let folders = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Outcome<Vec<_>>>()?;
    let all = std::iter::once(folder.to_owned()).chain(folders);
    all.map(|folder| folder.join(name))
        .find(|path| path.is_file())
        .ok_or_else(|| format!("no command makes {name}").into())
}

/// Runs the commands of a page in a temporary folder, and keeps the pictures that the page shows.
fn make_pictures(program: &Path, page: Page) -> Outcome<()> {
    let folder = tempfile::tempdir()?;
    std::os::unix::fs::symlink(root().join("scenes"), folder.path().join("scenes"))?;
    for (name, text) in page.files() {
        fs::write(folder.path().join(name), text)?;
    }
    for words in page.commands() {
        println!("{}: bentray {}", page.name, words.join(" "));
        let status = Command::new(program).args(&words).current_dir(folder.path()).status()?;
        if !status.success() {
            return Err(format!("{}: bentray {}", page.name, words.join(" ")).into());
        }
    }
    for target in links(page.text) {
        let Some(name) = target.strip_prefix("../../pictures/") else { continue };
        let kept = root().join("manual/pictures").join(name);
        match name.strip_suffix(".jpg") {
            None => _ = fs::copy(made(folder.path(), name)?, kept)?,
            Some(stem) => {
                let image = image::open(made(folder.path(), &format!("{stem}.png"))?)?.to_rgb8();
                image.write_with_encoder(image::codecs::jpeg::JpegEncoder::new_with_quality(
                    fs::File::create(kept)?,
                    88,
                ))?;
            }
        }
    }
    Ok(())
}
