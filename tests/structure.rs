//! The structure holds what the documentation promises of it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use bentray::program::{Pass, all_parts, constant};

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

/// scene ← program ← gpu ← render ← measure ← output, chart, bench ← cli.
#[test]
fn imports_run_one_way() {
    let order = ["scene", "program", "gpu", "render", "measure", "output", "chart", "bench", "error", "cli"];
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for (rank, module) in order.iter().enumerate() {
        let folder = source.join(module);
        let own = if folder.is_dir() { files(&folder, "rs") } else { vec![source.join(format!("{module}.rs"))] };
        for file in own {
            let text = std::fs::read_to_string(&file).unwrap();
            for later in &order[rank + 1..] {
                let import = format!("crate::{later}");
                assert!(!text.contains(&import), "{} imports {import}", file.display());
            }
            let knows_gpu = rank < 2 && text.contains("wgpu::") && !text.contains("naga::");
            assert!(!knows_gpu, "{} knows wgpu", file.display());
        }
    }
}

/// Every part opens with its contract.
#[test]
fn parts_state_their_contract() {
    for part in all_parts() {
        let first = part.text.lines().next().unwrap_or_default();
        assert!(first.starts_with("// ") && first.len() > 12, "{} opens with `{first}`", part.file);
    }
}

/// Parts that can be linked together never share a binding: only alternatives of one folder may.
#[test]
fn bindings_are_shared_only_by_alternatives() {
    let mut owners: BTreeMap<u32, Vec<(String, String)>> = BTreeMap::new();
    for part in all_parts() {
        for declaration in part.text.split("@binding(").skip(1) {
            let number = declaration.split(')').next().unwrap().parse().unwrap();
            let name = declaration.split(':').next().unwrap().rsplit(' ').next().unwrap();
            owners.entry(number).or_default().push((part.file.to_owned(), name.to_owned()));
        }
    }
    for (number, owners) in owners {
        let names: Vec<_> = owners.iter().map(|(_, name)| name).collect();
        let folders: Vec<_> = owners.iter().map(|(file, _)| file.split('/').next().unwrap()).collect();
        // Laws, flows and indices exclude each other too.
        let alternatives =
            folders.iter().all(|f| *f == folders[0]) || folders.iter().all(|f| ["law", "flow", "index"].contains(f));
        assert!(alternatives || names.iter().all(|n| *n == names[0]), "binding {number}: {owners:?}");
    }
}

/// The constants that the host reads from the shaders are there.
#[test]
fn shared_constants_are_in_the_shaders() {
    for (part, name) in [
        ("state/work", "WORK_LIMIT"),
        ("segment/curve_arc", "MAX_PIECES"),
        ("method/control/doubling_rejecting", "MAX_TRIES"),
        ("surface/material/emissive", "EMISSIVE"),
        ("surface/material/phong", "PHONG"),
        ("surface/pattern/constant", "CONSTANT"),
        ("surface/pattern/checker", "CHECKER"),
        ("surface/pattern/image", "IMAGE"),
        ("segment/ray", "MISSED"),
        ("segment/ray", "OUTSIDE"),
        ("segment/ray", "FAILED"),
        ("picture/adaptive", "RAYS"),
        ("pass/refine", "FIRST_SAMPLES"),
    ] {
        assert!(constant(part, name).is_finite());
    }
}

/// One name per stage: entry point, file and Rust variant.
#[test]
fn passes_bear_one_name() {
    let passes = [
        Pass::Setup,
        Pass::Advance,
        Pass::SingleStep,
        Pass::Integrate,
        Pass::Intersect,
        Pass::Terminate,
        Pass::Scatter,
        Pass::Shade,
        Pass::Record,
        Pass::Refine,
        Pass::Bare,
    ];
    let parts = all_parts();
    for pass in passes {
        let name = pass.entry();
        let part = parts.iter().find(|part| part.file == format!("pass/{name}.wgsl"));
        assert!(part.is_some_and(|part| part.text.contains(&format!("fn {name}("))), "{name}");
        assert_eq!(format!("{pass:?}").to_lowercase(), name.replace('_', ""));
    }
}
