//! The structure holds what the documentation promises of it.

use std::collections::BTreeMap;

use bentray::program::{Pass, all_parts};

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
