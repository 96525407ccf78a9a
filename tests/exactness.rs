//! 'Model no more than a scene needs', made executable: nothing can be taken out of a scene's program.

use bentray::program::{Linked, validated};

/// Everything that a module declares, by kind, as names.
fn declared(module: &naga::Module) -> Vec<String> {
    let named = |kind: &str, name: &Option<String>| format!("{kind} {}", name.as_deref().unwrap_or("?"));
    let mut all: Vec<String> = module.functions.iter().map(|(_, f)| named("fn", &f.name)).collect();
    all.extend(module.global_variables.iter().map(|(_, v)| named("var", &v.name)));
    all.extend(module.types.iter().filter(|(_, t)| t.name.is_some()).map(|(_, t)| named("type", &t.name)));
    all.extend(module.constants.iter().map(|(_, c)| named("const", &c.name)));
    all.extend(module.entry_points.iter().map(|e| format!("entry {}", e.name)));
    all
}

/// What naga would remove from the program as unused.
pub fn unused(linked: &Linked) -> Vec<String> {
    let mut module = validated(linked).unwrap_or_else(|error| panic!("{error}"));
    let before = declared(&module);
    naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
    let after = declared(&module);
    before.into_iter().filter(|name| !after.contains(name)).collect()
}
