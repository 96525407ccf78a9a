//! Checks the claims of the documentation about the structure of the code.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use bentray::program::{Pass, ShaderModule, all_parts, constant};

fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in folder.read_dir().unwrap().map(|entry| entry.unwrap().path()) {
        if entry.is_dir() {
            found.extend(files(&entry, extension));
        } else if entry.extension().is_some_and(|e| e == extension) {
            found.push(entry);
        }
    }
    found
}

/// Every module begins with its contract.
#[test]
fn parts_state_their_contract() {
    for part in all_parts() {
        let first = part.text.lines().next().unwrap_or_default();
        assert!(first.starts_with("// ") && first.len() > 12, "{} opens with `{first}`", part.file);
    }
}

/// A branch on a uniform makes lavapipe compile the pass again for every dispatch, and keep each of them in memory. What depends on the
/// sample, which each dispatch changes, branches on `sample_of(pixel)`.
#[test]
fn no_branch_depends_on_the_sample_as_a_uniform() {
    for part in all_parts() {
        for line in part.text.lines().filter(|line| line.contains("frame.sample")) {
            let branches = ["if ", "while ", "for ", "&&", "||"].iter().any(|word| line.contains(word));
            assert!(!branches, "{}: {line}", part.file);
        }
    }
}

/// Returns the rows with `N` columns in the tables of `shaders/README.md`, without their headings.
fn rows<const N: usize>() -> Vec<[String; N]> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders/README.md");
    let text = std::fs::read_to_string(path).unwrap();
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    let rows = text.lines().filter(|line| line.starts_with("| ")).filter_map(|line| cells(line).try_into().ok());
    rows.filter(|row: &[String; N]| !["area", "contract"].contains(&row[0].as_str())).collect()
}

/// Returns the names in backticks in a cell.
fn code(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

fn area(file: &str) -> &str {
    file.split('/').next().unwrap_or_default()
}

/// Returns a function without the names of its parameters, or the beginning of another declaration.
fn without_names(signature: &str) -> String {
    let mut pieces: Vec<&str> = signature.split(": ").collect();
    let last = pieces.pop().unwrap_or_default();
    let word = |c: char| c.is_alphanumeric() || c == '_';
    pieces.iter().map(|piece| piece.trim_end_matches(word)).chain([last]).collect()
}

/// Returns `true` if the text has the declaration of the signature, with its types.
fn declares(text: &str, signature: &str) -> bool {
    let lines = || text.lines().map(|line| line.trim_start_matches("@compute @workgroup_size(GROUP) "));
    if signature.starts_with("fn ") {
        let own = without_names(signature);
        return lines().filter_map(|line| line.strip_suffix(" {")).any(|line| without_names(line) == own);
    }
    let (_, declared) = signature.split_once(' ').unwrap();
    lines().any(|line| {
        let found =
            line.find(signature).or_else(|| line.starts_with(['@', 'v']).then(|| line.find(declared)).flatten());
        found.is_some_and(|at| !line[at..].starts_with(&format!("{signature}_")))
    })
}

/// Returns the declared name of a signature.
fn name(signature: &str) -> &str {
    let (_, declared) = signature.split_once(' ').unwrap();
    declared.split(['(', ':']).next().unwrap()
}

/// Returns the functions that a text declares.
fn functions(text: &str) -> Vec<&str> {
    let names = text.split("fn ").skip(1).map(|rest| rest.split('(').next().unwrap());
    names.filter(|name| name.chars().all(|c| c.is_alphanumeric() || c == '_')).collect()
}

fn without_comments(text: &str) -> String {
    text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

/// Returns a signature in the table of contracts, with the name of the module that implements it.
fn of_keeper(signature: &str, keeper: &str) -> String {
    signature.replace("KIND", keeper.rsplit('/').next().unwrap())
}

/// The contracts in `shaders/README.md` are those that their modules implement.
#[test]
fn the_table_of_contracts_is_true() {
    let parts = all_parts();
    let with_name = |name: &str| parts.iter().find(|part| part.file.strip_suffix(".wgsl") == Some(name));
    let rows = rows::<4>();
    assert!((50..=130).contains(&rows.len()), "{} contracts", rows.len());
    for [contract, _, signatures, keepers] in &rows {
        let (signatures, keepers) = (code(signatures), code(keepers));
        assert!(!signatures.is_empty() && keepers.len() > 1, "`{contract}` has only one implementation");
        for keeper in &keepers {
            let part = with_name(keeper).unwrap_or_else(|| panic!("`{contract}` names {keeper}, not a module"));
            for signature in signatures.iter().map(|signature| of_keeper(signature, keeper)) {
                assert!(declares(part.text, &signature), "{keeper} implements `{contract}` without `{signature}`");
            }
        }
    }
}

/// A function that other modules call is declared by one module, or belongs to a contract that the table states in full.
#[test]
fn functions_are_declared_once_or_by_contract() {
    let texts: Vec<(&str, String)> =
        all_parts().iter().map(|part| (part.file.trim_end_matches(".wgsl"), without_comments(part.text))).collect();
    let mut declared: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (file, text) in &texts {
        for name in functions(text) {
            declared.entry(name).or_default().insert(file);
        }
    }
    let mut stated: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for [_, _, signatures, keepers] in rows::<4>() {
        for keeper in code(&keepers) {
            for signature in code(&signatures).into_iter().filter(|signature| signature.starts_with("fn ")) {
                let signature = of_keeper(signature, keeper);
                stated.entry(name(&signature).to_owned()).or_default().insert(keeper.to_owned());
            }
        }
    }
    let uses = |text: &str, name: &str| text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == name);
    for (name, files) in declared.iter().filter(|(_, files)| files.len() > 1) {
        let called = texts.iter().find(|(file, text)| !files.contains(file) && uses(text, name));
        let in_full =
            stated.get(*name).is_some_and(|keepers| keepers.iter().map(String::as_str).eq(files.iter().copied()));
        if let Some((caller, _)) = called {
            assert!(in_full, "{caller} calls `{name}`, which {files:?} declare, but the table does not list it");
        }
    }
}

/// Every module and every constant that the Rust code names exists in the shaders.
#[test]
fn what_the_host_names_is_in_the_shaders() {
    let parts = all_parts();
    let areas: BTreeSet<&str> = parts.iter().map(|part| area(part.file)).collect();
    let mut constants = 0;
    for file in files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), "rs") {
        let text = std::fs::read_to_string(&file).unwrap();
        let literals: Vec<&str> = text.split('"').collect();
        for window in literals.windows(3) {
            let [literal, between, next] = window else { continue };
            let plain = literal.contains('/') && literal.chars().all(|c| c.is_alphanumeric() || "/_".contains(c));
            if !plain || !areas.contains(area(literal)) {
                continue;
            }
            let is =
                |part: &&ShaderModule| part.file.strip_prefix(literal).is_some_and(|rest| rest.starts_with(['.', '/']));
            assert!(parts.iter().any(|part| is(&part)), "{} names `{literal}`", file.display());
            let constant_name = next.chars().all(|c| c.is_ascii_uppercase() || c == '_');
            if *between == ", " && constant_name {
                assert!(constant(literal, next).is_finite());
                constants += 1;
            }
        }
    }
    assert!(constants > 10, "only {constants} constants were found");
}

/// Each stage has one name: entry point, file and Rust variant.
#[test]
fn each_pass_has_one_name() {
    let passes = [
        Pass::Setup,
        Pass::Advance,
        Pass::SingleStep,
        Pass::Integrate,
        Pass::Intersect,
        Pass::Terminate,
        Pass::Scatter,
        Pass::Whole,
        Pass::Shade,
        Pass::Reshade,
        Pass::Record,
        Pass::Refine,
        Pass::MeasureBundles,
        Pass::FindStars,
        Pass::LightStars,
        Pass::GatherStars,
        Pass::Bare,
        Pass::Shots,
    ];
    let parts = all_parts();
    let files = parts.iter().filter_map(|part| part.file.strip_prefix("pass/")?.strip_suffix(".wgsl"));
    assert_eq!(files.collect::<BTreeSet<_>>(), passes.into_iter().map(Pass::entry).collect());
    for pass in passes {
        let name = pass.entry();
        let part = parts.iter().find(|part| part.file == format!("pass/{name}.wgsl"));
        assert!(part.is_some_and(|part| part.text.contains(&format!("fn {name}("))), "{name}");
        assert_eq!(format!("{pass:?}").to_lowercase(), name.replace('_', ""));
    }
}

/// The compiler denies `unsafe` everywhere; one function allows it.
#[test]
fn unsafe_code_is_in_one_place() {
    let allow = "allow(unsafe_code)";
    let all = files(Path::new("src"), "rs").into_iter();
    let found: Vec<_> = all.filter(|file| std::fs::read_to_string(file).unwrap().contains(allow)).collect();
    assert_eq!(found, [Path::new("src/gpu/pipeline.rs")]);
}

/// `cargo test` ignores a test that needs another program; `make test` must list when to run it.
#[test]
fn make_test_knows_every_ignored_test() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let makefile = std::fs::read_to_string(root.join("Makefile")).unwrap();
    let mut ignored = 0;
    for file in files(&root.join("tests"), "rs").into_iter().chain(files(&root.join("src"), "rs")) {
        let text = std::fs::read_to_string(&file).unwrap();
        for test in text.split(concat!("#[", "ignore")).skip(1) {
            let name = test.split("fn ").nth(1).and_then(|test| test.split('(').next()).unwrap();
            let needed = name.rsplit('_').next().unwrap();
            assert!(makefile.contains(&format!("needs with_{needed} ")), "{}: {name}", file.display());
            assert!(name.ends_with(&format!("_with_{needed}")) && test.starts_with(" = \"needs "), "{name}");
            ignored += 1;
        }
    }
    assert!(ignored > 0, "no test is ignored");
}
