//! Imports run one way: between top-level modules, and between the files of a folder.
//!
//! A module is a file, or a folder with all its files. `super::x`, `crate::a::b` and names that a folder re-exports by `pub
//! use` count as imports of the file that contains them; the declarations in the `mod.rs` of a folder belong to the folder,
//! and its files may import them.

use std::collections::{BTreeMap, BTreeSet};

use crate::support::sources;

/// The imports between modules: for each path of a module the paths that it names.
type Imports = BTreeMap<Vec<String>, BTreeSet<Vec<String>>>;

fn path(file: &str) -> Vec<String> {
    let path = file.trim_end_matches(".rs").trim_end_matches("/mod");
    path.split('/').filter(|name| !matches!(*name, "mod" | "lib")).map(str::to_owned).collect()
}

/// Returns the text of a module without its tests and comments.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// Returns the paths of a tree such as `a::{b, c::{d, e}}`.
fn leaves(tree: &str) -> Vec<String> {
    let tree = tree.trim();
    let Some((front, inside)) = tree.split_once('{') else {
        return vec![tree.split(" as ").next().unwrap_or_default().trim().to_owned()];
    };
    let (mut depth, mut from, mut found) = (0, 0, Vec::new());
    let inside = inside.trim_end().strip_suffix('}').unwrap_or(inside);
    for (i, sign) in inside.char_indices().chain([(inside.len(), ',')]) {
        depth += i32::from(sign == '{') - i32::from(sign == '}');
        if sign == ',' && depth == 0 {
            found.extend(leaves(&inside[from..i]).into_iter().filter(|leaf| !leaf.is_empty()));
            from = i + 1;
        }
    }
    found.iter().map(|leaf| format!("{front}{leaf}")).collect()
}

/// Returns every path that the code of a module names, in imports and elsewhere.
fn named(code: &str) -> Vec<String> {
    let uses = code.split("use ").skip(1).flat_map(|rest| leaves(rest.split(';').next().unwrap_or_default()));
    let is_path = |c: char| c.is_alphanumeric() || matches!(c, '_' | ':');
    let words = code.split(|c| !is_path(c)).filter(|word| word.starts_with("crate::") || word.starts_with("super::"));
    uses.chain(words.map(str::to_owned)).collect()
}

/// Returns the names that folders re-export, and the modules that define them.
fn handed_on(all: &[(Vec<String>, String)]) -> BTreeMap<Vec<String>, Vec<String>> {
    let mut found = BTreeMap::new();
    for (folder, code) in all {
        for rest in code.split("use ").skip(1) {
            for leaf in leaves(rest.split(';').next().unwrap_or_default()) {
                let inner: Vec<&str> = leaf.split("::").filter(|name| *name != "self").collect();
                let [front @ .., name] = inner.as_slice() else { continue };
                let module: Vec<String> = folder.iter().cloned().chain(front.iter().map(ToString::to_string)).collect();
                if *folder != module && all.iter().any(|(path, _)| *path == module) {
                    let own: Vec<String> = folder.iter().cloned().chain([(*name).to_owned()]).collect();
                    if own != module {
                        found.insert(own, module);
                    }
                }
            }
        }
    }
    found
}

fn imports() -> Imports {
    let all: Vec<_> = sources().iter().map(|(file, text)| (path(file), code(text))).collect();
    let handed_on = handed_on(&all);
    let mut imports = Imports::new();
    for (own, code) in &all {
        for name in named(code) {
            let mut at = own.clone();
            for step in name.split("::") {
                match step {
                    "crate" => at.clear(),
                    "super" => drop(at.pop()),
                    "self" => {}
                    step => at.push(step.to_owned()),
                }
                while let Some(module) = handed_on.get(&at) {
                    at.clone_from(module);
                }
            }
            let of = |path: &[String]| all.iter().any(|(module, _)| module == path);
            while !at.is_empty() && !of(&at) {
                at.pop();
            }
            if name.starts_with("crate") || name.starts_with("super") || name.starts_with("self") {
                imports.entry(own.clone()).or_default().insert(at);
            }
        }
    }
    imports
}

/// Returns the modules of `src` in the order of imports that CONTRIBUTING.md allows.
fn order() -> Vec<String> {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/CONTRIBUTING.md")).unwrap();
    let table = text.lines().skip_while(|line| *line != "| module | contents |").skip(2);
    let rows = table.take_while(|line| line.starts_with('|'));
    rows.map(|row| row.split('`').nth(1).unwrap().to_owned()).collect()
}

/// A module imports from modules before it in CONTRIBUTING.md's table, which lists all modules, and no module before `gpu` uses wgpu.
#[test]
fn imports_run_one_way() {
    let order = order();
    let rank = |path: &[String]| order.iter().position(|name| path.first().is_some_and(|first| first == name));
    let imports = imports();
    assert!(imports.len() > 50, "the search does not find imports in their present form");
    for (own, named) in &imports {
        for other in named {
            let runs_back = rank(own).zip(rank(other)).is_some_and(|(own, other)| other > own);
            assert!(!runs_back, "{} imports {}", own.join("::"), other.join("::"));
        }
    }
    let files = sources();
    let modules: BTreeSet<_> =
        files.iter().map(|(file, _)| path(file)).filter_map(|path| path.first().cloned()).collect();
    let named: BTreeSet<_> = order.iter().cloned().chain(["main".to_owned()]).collect();
    assert_eq!(modules, named, "modules of src, and of the table in CONTRIBUTING.md");
    for (file, text) in &files {
        let is_before = rank(&path(file)) < rank(&["gpu".to_owned()]);
        assert!(!(is_before && code(text).contains("wgpu::")), "{file} uses wgpu");
    }
}

/// No two modules of a folder need each other, even indirectly.
#[test]
fn no_folder_has_circles() {
    let mut edges: BTreeMap<(Vec<String>, String), BTreeSet<String>> = BTreeMap::new();
    for (own, named) in imports() {
        for other in named {
            let common = own.iter().zip(&other).take_while(|(a, b)| a == b).count();
            if let (Some(a), Some(b)) = (own.get(common), other.get(common)) {
                edges.entry((own[..common].to_vec(), a.clone())).or_default().insert(b.clone());
            }
        }
    }
    let reached = |folder: &Vec<String>, from: &String| {
        let (mut found, mut open) = (BTreeSet::new(), vec![from.clone()]);
        while let Some(module) = open.pop() {
            for next in edges.get(&(folder.clone(), module)).into_iter().flatten() {
                if found.insert(next.clone()) {
                    open.push(next.clone());
                }
            }
        }
        found
    };
    let mut circles = BTreeSet::new();
    for (folder, module) in edges.keys() {
        let circle: Vec<_> =
            reached(folder, module).into_iter().filter(|other| reached(folder, other).contains(module)).collect();
        if circle.contains(module) {
            circles.insert(format!("{}: {}", folder.join("/"), circle.join(" ")));
        }
    }
    assert!(circles.is_empty(), "{circles:?}");
}

#[test]
fn trees_of_imports_are_read() {
    assert_eq!(leaves("a::{b, c::{d, e as f}}"), ["a::b", "a::c::d", "a::c::e"]);
    assert!(named("use super::{x, y::Z};\nlet a = crate::scene::Shape::Box;").contains(&"super::y::Z".to_owned()));
}
