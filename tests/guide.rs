//! The guide and the README say what is so: their scenes load, their commands run, their keys exist, and every page is in its lists.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread;

use bentray::guide::{PAGES, pages, physics};
use bentray::scene::{REFERENCE, Scene};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(file: &str) -> String {
    std::fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// Every text that users read, by its name.
fn texts() -> Vec<(String, String)> {
    let pages = pages().map(|page| (page.name.to_owned(), page.text.to_owned()));
    [("README.md".to_owned(), read("README.md"))].into_iter().chain(pages).collect()
}

/// The contents of a text's blocks of code that begin with this word behind the fence.
fn blocks(text: &str, language: &str) -> Vec<String> {
    let mut fences = text.split("```");
    let mut found = Vec::new();
    while let (Some(_), Some(block)) = (fences.next(), fences.next()) {
        found.extend(block.strip_prefix(language).and_then(|rest| rest.strip_prefix('\n')).map(str::to_owned));
    }
    found
}

/// What a text has between single backticks, outside of blocks.
fn spans(text: &str) -> Vec<String> {
    let prose = text.split("```").step_by(2);
    prose.flat_map(|prose| prose.split('`').skip(1).step_by(2).map(|span| span.replace('\n', " "))).collect()
}

/// A scene of what a page shows of one: what it lacks of a camera, of a bound and of materials that it names is added.
fn whole_scene(shown: &str) -> String {
    let mut scene = shown.to_owned();
    let has = |table: &str| shown.lines().any(|line| line.starts_with(table));
    if !has("[camera]") {
        scene += "\n[camera]\nposition = [0, 0, 9]\n";
    }
    if !has("[rays]") {
        scene += "\n[rays]\nbounding_sphere = { radius = 30 }\n";
    }
    let named: BTreeSet<&str> =
        shown.split("\nmaterial = \"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    for name in named.into_iter().filter(|name| !has(&format!("[materials.{name}]"))) {
        scene.extend(["\n[materials.", name, "]\n"]);
    }
    scene
}

/// Files are looked for beside the scenes that have them.
fn folder_of(scene: &str) -> PathBuf {
    let files: Vec<&str> = scene.split('"').filter(|word| word.contains('.') && word.ends_with("wgsl")).collect();
    let folders = ["scenes", "scenes/laws"].map(|folder| root().join(folder));
    let found = folders.into_iter().find(|folder| files.iter().all(|file| folder.join(file).exists()));
    found.unwrap_or_else(|| panic!("no folder has {files:?}"))
}

#[test]
fn what_is_shown_of_scenes_loads() {
    let mut count = 0;
    for (name, text) in texts() {
        for shown in blocks(&text, "toml") {
            let scene = whole_scene(&shown);
            let loaded = Scene::parse(&scene, &folder_of(&scene).join("shown.toml"), &[]);
            assert!(loaded.is_ok(), "{name}: {}\n{scene}", loaded.unwrap_err());
            count += 1;
        }
    }
    assert!(count > 25, "{count}");
}

/// The words of a line, as a shell splits them.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut quote, mut begun) = (vec![String::new()], None, false);
    for sign in line.chars() {
        match quote {
            None if sign == '"' || sign == '\'' => (quote, begun) = (Some(sign), true),
            Some(open) if sign == open => quote = None,
            None if sign == ' ' && (begun || words.last().is_some_and(|word| !word.is_empty())) => {
                words.push(String::new());
                begun = false;
            }
            None if sign == ' ' => {}
            _ => words.last_mut().unwrap().push(sign),
        }
    }
    words
}

/// The commands that a text has in blocks of `sh`, without the program's name.
fn commands(text: &str) -> Vec<Vec<String>> {
    let lines: Vec<String> =
        blocks(text, "sh").iter().flat_map(|block| block.lines().map(str::to_owned).collect::<Vec<_>>()).collect();
    lines.iter().filter_map(|line| line.strip_prefix("bentray ")).map(words).collect()
}

/// Runs a command in a folder; scenes are the project's.
fn run(folder: &Path, cache: &Path, words: &[String]) -> Output {
    let scene = |word: &String| {
        if word.starts_with("scenes/") { root().join(word).display().to_string() } else { word.clone() }
    };
    let mut command = Command::new(env!("CARGO_BIN_EXE_bentray"));
    command.args(words.iter().map(scene)).current_dir(folder).stdin(Stdio::null());
    command.env("BENTRAY_CACHE", cache).output().unwrap()
}

/// The same command, but quick: a small picture of few samples, the first of some frames, a coarse grid.
fn quick(words: &[String]) -> Vec<String> {
    let has = |flag: &str| words.iter().any(|word| word == flag);
    let mut quick = words.to_vec();
    for (flag, value) in words.iter().zip(words.iter().skip(1)) {
        let at = quick.iter().position(|word| word == value).unwrap();
        match flag.as_str() {
            "--samples" => quick[at] = (value.parse::<u32>().unwrap() / 256).max(2).to_string(),
            // A few that a film is made of are all needed.
            "--frames" if value != "0..3" => quick[at] = value.split("..").next().unwrap().replace("all", "0"),
            _ => {}
        }
    }
    let mut add = |more: &str| quick.extend(more.split(' ').map(str::to_owned));
    match words[0].as_str() {
        "render" if !has("--samples") => add("--samples 2"),
        "light" => add("--set lights.0.voxels=8"),
        _ => {}
    }
    if words[0] == "render" && (!has("--size") || has("400x300")) {
        add("--set image.size=[24,16]");
    }
    if let Some(at) = quick.iter().position(|word| word == "400x300") {
        quick.drain(at - 1..=at);
    }
    quick
}

/// A command that takes long whatever it is given: the line is read to its end, and then only its help is asked for.
fn only_read(words: &[String]) -> Vec<String> {
    words.iter().cloned().chain(["--help".to_owned()]).collect()
}

/// A render as a check of its scene, with the same changes.
fn checked(words: &[String]) -> Vec<String> {
    let changes = words.iter().zip(&words[1..]).filter(|(flag, _)| *flag == "--set");
    let changes = changes.flat_map(|(flag, change)| [flag.clone(), change.clone()]);
    ["check".to_owned(), words[1].clone()].into_iter().chain(changes).collect()
}

/// Every command of README and guide runs, in its page's order. Those of the physics pages are rendered by the gallery's test.
#[test]
fn commands_run() {
    let cache = tempfile::tempdir().unwrap();
    let run_all = |name: &str, text: &str| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("places.csv"), "x,y,z\n0.5,0,0.5\n").unwrap();
        let is_physics = physics::PAGES.iter().any(|page| page.name == name);
        let commands = commands(text);
        for words in &commands {
            let runs = match words[0].as_str() {
                "compare" | "bench" => vec![only_read(words)],
                "render" if is_physics => vec![only_read(words), checked(words)],
                _ => vec![quick(words)],
            };
            for words in runs {
                let output = run(folder.path(), cache.path(), &words);
                assert!(output.status.success(), "{name}: {words:?}: {}", String::from_utf8_lossy(&output.stderr));
            }
        }
        commands.len()
    };
    let texts = texts();
    let count: usize = thread::scope(|scope| {
        let running: Vec<_> = texts.iter().map(|(name, text)| scope.spawn(|| run_all(name, text))).collect();
        running.into_iter().map(|page| page.join().unwrap()).sum()
    });
    assert!(count > 50, "{count}");
}

/// What prose calls `bentray NAME` is a command.
#[test]
fn commands_that_are_named_exist() {
    let folder = tempfile::tempdir().unwrap();
    let named: BTreeSet<String> = texts()
        .iter()
        .flat_map(|(_, text)| spans(text))
        .filter_map(|span| span.strip_prefix("bentray ").map(|rest| rest.split(' ').next().unwrap().to_owned()))
        .collect();
    assert!(named.len() > 8, "{named:?}");
    for name in named {
        let output = run(folder.path(), folder.path(), &[name.clone(), "--help".to_owned()]);
        assert!(output.status.success(), "there is no `bentray {name}`");
    }
}

/// What prose calls by a table's name and a key, such as `camera.redshift`, is a key of the reference.
#[test]
fn keys_that_are_named_exist() {
    let tables: BTreeSet<&str> = REFERENCE.iter().map(|key| key.table).filter(|table| !table.contains('.')).collect();
    let mut count = 0;
    for (name, text) in texts() {
        let files = [".toml", ".wgsl", ".md", ".png", ".exr"];
        for span in spans(&text).iter().filter(|span| files.iter().all(|end| !span.ends_with(end))) {
            let path = span.split(" = ").next().unwrap();
            let parts: Vec<&str> = path.split('.').filter(|part| part.parse::<u32>().is_err()).collect();
            let is_key = path.chars().all(|c| c.is_ascii_lowercase() || c == '_' || c == '.' || c.is_ascii_digit());
            let [table @ .., key] = parts.as_slice() else { continue };
            if !is_key || path.starts_with('.') || table.is_empty() || !tables.contains(table[0]) {
                continue;
            }
            let table = table.join(".");
            let known = REFERENCE.iter().any(|own| own.table == table && own.key == *key);
            assert!(known, "{name}: there is no key `{path}`");
            count += 1;
        }
    }
    assert!(count > 15, "{count}");
}

fn markdown_in(folder: &Path) -> BTreeSet<PathBuf> {
    let entries: Vec<PathBuf> = folder.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    let (folders, files): (Vec<_>, Vec<_>) = entries.into_iter().partition(|path| path.is_dir());
    let own = files.into_iter().filter(|path| path.extension().is_some_and(|e| e == "md"));
    own.chain(folders.iter().flat_map(|folder| markdown_in(folder))).collect()
}

#[test]
fn every_page_is_in_its_lists() {
    let folder = root().join("src/guide");
    let file = |name: &str| {
        let own = folder.join(format!("{name}.md"));
        if own.exists() { own } else { folder.join(format!("physics/{name}.md")) }
    };
    assert_eq!(markdown_in(&folder), pages().map(|page| file(page.name)).collect());
    let (readme, contents) = (read("README.md"), read("src/guide/mod.rs"));
    for page in PAGES {
        assert!(
            readme.contains(&format!("| [{0}](src/guide/{0}.md) | ", page.name)),
            "{} is not in the README",
            page.name
        );
        assert!(contents.contains(&format!("| [`{}`] | ", page.name)), "{} is not in src/guide/mod.rs", page.name);
    }
    for page in physics::PAGES {
        assert!(
            physics::CONTENTS.text.contains(&format!("| [`{}`] | ", page.name)),
            "{} is not in physics.md",
            page.name
        );
    }
}

#[test]
fn texts_are_short() {
    for (name, text) in texts() {
        let (lines, most) = (text.lines().count(), if name == "README.md" { 149 } else { 300 });
        assert!(lines <= most, "{name} has {lines} lines");
        assert!(text.contains("\n# ") || text.starts_with("# "), "{name} has no title");
    }
}

/// What links of the README and of CONTRIBUTING.md lead to is there, and in the crate that is published.
#[test]
fn links_lead_somewhere() {
    let list = ["package", "--list", "--allow-dirty", "--offline"];
    let listed = Command::new(env!("CARGO")).args(list).current_dir(root()).output().unwrap();
    let listed = String::from_utf8(listed.stdout).unwrap();
    assert!(listed.lines().any(|file| file == "src/main.rs"), "{listed}");
    for page in ["README.md", "CONTRIBUTING.md", "scenes/README.md"] {
        let text = read(page);
        let folder = Path::new(page).parent().unwrap();
        let links = text.split("](").skip(1).map(|rest| rest.split(')').next().unwrap());
        for link in links.filter(|link| !link.contains("://")) {
            let path = folder.join(link);
            assert!(root().join(&path).exists(), "{page}: {link}");
            let is_packaged = listed.lines().any(|file| Path::new(file).starts_with(&path));
            assert!(is_packaged, "{page}: {link} is not in the crate");
        }
    }
}

#[test]
fn words_are_split_as_a_shell_does() {
    assert_eq!(words("a  --set 'b c' \"d e\"f x='y z'"), ["a", "--set", "b c", "d ef", "x=y z"]);
}
