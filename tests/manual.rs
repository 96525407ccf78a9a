//! The manual and the README are correct: their scenes load, their commands run, their keys, links and images exist, and every page is
//! listed.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread;

use bentray::guide::{Page, blocks, pages};
use bentray::scene::{REFERENCE, Scene};

use crate::links::links;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(file: &str) -> String {
    std::fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// Returns every text that users read, with its name.
fn texts() -> Vec<(String, String)> {
    let pages = pages().map(|page| (page.name.to_owned(), page.text.to_owned()));
    [("README.md".to_owned(), read("README.md"))].into_iter().chain(pages).collect()
}

/// Returns the contents of single backticks in a text, outside of blocks.
fn spans(text: &str) -> Vec<String> {
    let prose = text.split("```").step_by(2);
    prose.flat_map(|prose| prose.split('`').skip(1).step_by(2).map(|span| span.replace('\n', " "))).collect()
}

/// Completes an excerpt of a scene: adds a camera, a bounding sphere and the materials that it names, if these are missing.
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

/// Returns the folder of scenes that has these files.
fn folder_of(scene: &str) -> PathBuf {
    if scene.contains("\"scenes/") {
        return root().to_owned();
    }
    let files: Vec<&str> = scene.split('"').filter(|word| word.contains('.') && word.ends_with("wgsl")).collect();
    let folders = ["scenes", "scenes/laws"].map(|folder| root().join(folder));
    let found = folders.into_iter().find(|folder| files.iter().all(|file| folder.join(file).exists()));
    found.unwrap_or_else(|| panic!("no folder has {files:?}"))
}

#[test]
fn what_is_shown_of_scenes_loads() {
    let mut count = 0;
    for (name, text) in texts() {
        // Files that the reader saves are read by the commands of the page.
        let is_file =
            |shown: &&str| shown.starts_with("# ") && shown.lines().next().unwrap().split('.').nth(1) == Some("toml");
        for shown in blocks(&text, "toml").into_iter().filter(|shown| !is_file(shown)) {
            let scene = whole_scene(shown);
            let loaded = Scene::parse(&scene, &folder_of(&scene).join("shown.toml"), &[]);
            assert!(loaded.is_ok(), "{name}: {}\n{scene}", loaded.unwrap_err());
            count += 1;
        }
    }
    assert!(count > 25, "{count}");
}

/// Runs a command in a folder.
fn run(folder: &Path, cache: &Path, words: &[String]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_bentray"));
    command.args(words).current_dir(folder).stdin(Stdio::null()).env("BENTRAY_CACHE", cache).output().unwrap()
}

/// Returns a fast variant of the command: a small image of few samples, the first of several frames, a coarse grid.
fn quick(words: &[String]) -> Vec<String> {
    let has = |flag: &str| words.iter().any(|word| word == flag);
    let mut quick = words.to_vec();
    for (flag, value) in words.iter().zip(words.iter().skip(1)) {
        let at = quick.iter().position(|word| word == value).unwrap();
        match flag.as_str() {
            "--samples" => quick[at] = (value.parse::<u32>().unwrap() / 256).max(2).to_string(),
            // The few frames of a video are all needed.
            "--frames" if value != "0..3" => quick[at] = value.split("..").next().unwrap().replace("all", "0"),
            _ => {}
        }
    }
    let mut add = |more: &str| quick.extend(more.split(' ').map(str::to_owned));
    match words[0].as_str() {
        "render" | "map" if !has("--samples") => add("--samples 2"),
        "light" => add("--set lights.0.voxels=8"),
        _ => {}
    }
    // The rows and columns of a region refer to the given size.
    if ["render", "map"].contains(&words[0].as_str()) && !has("--crop") {
        if let Some(at) = quick.iter().position(|word| word == "--size") {
            quick.drain(at..at + 2);
        }
        quick.extend(["--set".to_owned(), "image.size=[24,16]".to_owned()]);
    }
    quick
}

/// Returns a variant of a command that is always slow: its options are parsed, but then it only prints its help.
fn only_read(words: &[String]) -> Vec<String> {
    words.iter().cloned().chain(["--help".to_owned()]).collect()
}

/// Returns a check of the scene of a render, with the same changes.
fn checked(words: &[String]) -> Vec<String> {
    let changes = words.iter().zip(&words[1..]).filter(|(flag, _)| *flag == "--set");
    let changes = changes.flat_map(|(flag, change)| [flag.clone(), change.clone()]);
    ["check".to_owned(), words[1].clone()].into_iter().chain(changes).collect()
}

/// Returns `true` if a later command reads a file that this one writes.
fn is_read(words: &[String], later: &[Vec<String>]) -> bool {
    let outputs = words.iter().zip(&words[1..]).filter(|(flag, _)| *flag == "-o").map(|(_, file)| file);
    let stems: Vec<&str> = outputs.map(|file| file.split(['.', '{']).next().unwrap()).collect();
    let is_scene = |file: &str| Path::new(file).extension() == Some("toml".as_ref());
    later.iter().any(|words| {
        let inputs = words.iter().zip(&words[1..]).filter(|(flag, word)| *flag != "-o" && !is_scene(word));
        let mut names = inputs.flat_map(|(_, word)| word.split('='));
        names.any(|name| stems.iter().any(|stem| name.starts_with(stem)))
    })
}

/// Runs every command of README and manual in the order of its page. The first render of each page runs at a small size, and so does
/// a render whose files a later command reads. For all others the options are parsed and the scene is checked, with its changes.
#[test]
fn commands_run() {
    let cache = tempfile::tempdir().unwrap();
    let run_all = |page: Page| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("places.csv"), "x,y,z\n0.5,0,0.5\n").unwrap();
        std::os::unix::fs::symlink(root().join("scenes"), folder.path().join("scenes")).unwrap();
        for (name, text) in page.files() {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        let commands = page.commands();
        let first = commands.iter().position(|words| words[0] == "render");
        for (i, words) in commands.iter().enumerate() {
            let is_small = first == Some(i) && page.part != "Physics" || is_read(words, &commands[i + 1..]);
            let succeeds = |words: &[String]| {
                let output = run(folder.path(), cache.path(), words);
                output
                    .status
                    .success()
                    .then_some(())
                    .ok_or_else(|| format!("{}: {words:?}: {}", page.name, String::from_utf8_lossy(&output.stderr)))
            };
            let ran = match words[0].as_str() {
                "compare" | "bench" => succeeds(&only_read(words)),
                // A key that the animation changes can be set for one frame, but not checked.
                "render" if !is_small => succeeds(&only_read(words))
                    .and_then(|()| succeeds(&checked(words)).or_else(|_| succeeds(&quick(words)))),
                _ => succeeds(&quick(words)),
            };
            ran.unwrap_or_else(|error| panic!("{error}"));
        }
        commands.len()
    };
    let mut all: Vec<Page> = pages().collect();
    let readme = read("README.md").leak();
    all.push(Page { part: "", name: "README", title: "", path: "../README.md", text: readme });
    let next = std::sync::Mutex::new(all.into_iter());
    let count: usize = thread::scope(|scope| {
        let work = || std::iter::from_fn(|| next.lock().unwrap().next()).map(run_all).sum::<usize>();
        let running: Vec<_> = (0..3).map(|_| scope.spawn(work)).collect();
        running.into_iter().map(|worker| worker.join().unwrap()).sum()
    });
    assert!(count > 200, "{count}");
}

/// Checks that `bentray NAME` in prose is a command.
#[test]
fn commands_that_are_named_exist() {
    let folder = tempfile::tempdir().unwrap();
    let named: BTreeSet<String> = texts()
        .iter()
        .flat_map(|(_, text)| spans(text))
        .filter_map(|span| span.strip_prefix("bentray ").map(|rest| rest.split(' ').next().unwrap().to_owned()))
        .filter(|name| !name.is_empty())
        .collect();
    assert!(named.len() > 8, "{named:?}");
    for name in named {
        let output = run(folder.path(), folder.path(), &[name.clone(), "--help".to_owned()]);
        assert!(output.status.success(), "there is no `bentray {name}`");
    }
}

/// Checks that a table and a key in prose, such as `camera.redshift`, are a key of the reference.
#[test]
fn keys_that_are_named_exist() {
    let tables: BTreeSet<&str> = REFERENCE.iter().map(|key| key.table).filter(|table| !table.contains('.')).collect();
    let mut count = 0;
    for (name, text) in texts() {
        let files = [".toml", ".wgsl", ".md", ".png", ".exr", ".csv", ".svg", ".jpg", ".glb"];
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
fn every_page_is_listed() {
    let files = markdown_in(&root().join("manual/pages"));
    assert_eq!(files, pages().map(|page| root().join("manual").join(page.path)).collect());
    let names: BTreeSet<&str> = pages().map(|page| page.name).collect();
    assert_eq!(names.len(), files.len(), "two pages have one name");
    for page in pages() {
        assert!(page.text.starts_with("# "), "{} has no title", page.name);
    }
}

/// Checks that every image of the manual is shown, on a page with a command or a program that makes it.
#[test]
fn pictures_are_made_by_commands() {
    let mut shown = BTreeSet::new();
    for page in pages() {
        for target in links(page.text).targets {
            let Some(name) = target.strip_prefix("../../pictures/") else { continue };
            let stem = name.split('.').next().unwrap().trim_end_matches(|sign: char| sign.is_ascii_digit());
            let file = |word: &str| word.rsplit('/').next().unwrap().to_owned();
            // `compare` writes charts whose names begin with the name of the scene.
            let is_chart =
                |words: &[String]| words[0] == "compare" && stem.starts_with(file(&words[1]).trim_end_matches(".toml"));
            let is_written =
                |words: &Vec<String>| is_chart(words) || words.iter().any(|word| file(word).starts_with(stem));
            let mut code = page.text.split("```").skip(1).step_by(2);
            let is_made =
                page.commands().iter().any(is_written) || code.any(|block| block.contains(&format!("{stem}.")));
            assert!(is_made, "{}: no command makes {name}", page.name);
            shown.insert(name.to_owned());
        }
    }
    let kept = root().join("manual/pictures").read_dir().unwrap();
    assert_eq!(kept.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect::<BTreeSet<_>>(), shown);
}

#[test]
fn texts_are_short() {
    for (name, text) in texts() {
        let (lines, most) = (text.lines().count(), if name == "README.md" { 149 } else { 300 });
        assert!(lines <= most, "{name} has {lines} lines");
        assert!(text.contains("\n# ") || text.starts_with("# "), "{name} has no title");
    }
}

/// Checks that the targets of links in the README and in CONTRIBUTING.md exist, and are in the published crate.
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
