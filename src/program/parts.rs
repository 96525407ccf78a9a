//! The built-in WGSL modules, embedded in the binary.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use include_dir::{Dir, File, include_dir};

use super::declarations::declarations;
use super::tokens::Tokens;

static SHADERS: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/shaders");

/// A built-in module: a WGSL file of `shaders/` that implements one contract.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShaderModule {
    /// The path below `shaders/`, such as `law/sources.wgsl`.
    pub file: &'static str,
    /// Its text.
    pub text: &'static str,
}

/// All modules by path.
static PARTS: LazyLock<BTreeMap<&str, ShaderModule>> =
    LazyLock::new(|| parts_in(&SHADERS).map(|part| (part.file.trim_end_matches(".wgsl"), part)).collect());

/// The tokens of all modules by file.
static TOKENS: LazyLock<BTreeMap<&str, Tokens<'static>>> =
    LazyLock::new(|| PARTS.values().map(|part| (part.file, Tokens::of(part.text))).collect());

/// Returns the tokens of a module's file; each file is read once.
pub(super) fn part_tokens(file: &str) -> Option<Tokens<'static>> {
    TOKENS.get(file).cloned()
}

/// Returns the module `name`, a path below `shaders/` without its extension.
#[must_use]
pub fn part(name: &str) -> Option<ShaderModule> {
    PARTS.get(name).copied()
}

/// Returns every module, sorted by path.
#[must_use]
pub fn all_parts() -> Vec<ShaderModule> {
    PARTS.values().copied().collect()
}

fn parts_in(folder: &'static Dir) -> Box<dyn Iterator<Item = ShaderModule>> {
    let part = |file: &'static File| Some(ShaderModule { file: file.path().to_str()?, text: file.contents_utf8()? });
    let wgsl = folder.files().filter(|file| file.path().extension().is_some_and(|extension| extension == "wgsl"));
    Box::new(wgsl.filter_map(part).chain(folder.dirs().flat_map(parts_in)))
}

/// Returns the value of the constant `name` in a module, or the default of an override. The value is thus written only once, in WGSL.
///
/// # Panics
///
/// If there is no such module or constant. Modules are embedded, and a test reads every constant that the host uses.
#[must_use]
pub fn constant(part_name: &str, name: &str) -> f64 {
    let part = part(part_name).unwrap_or_else(|| panic!("no part {part_name}"));
    let found = part_tokens(part.file).and_then(|tokens| declarations(tokens).ok()).unwrap_or_default();
    let declared = found.iter().find(|d| matches!(d.keyword(), "const" | "override") && d.name() == name);
    let value = declared.and_then(|d| number(&d.tokens.written(d.value()?)));
    value.unwrap_or_else(|| panic!("{part_name} has no constant {name} with a plain number"))
}

fn number(text: &str) -> Option<f64> {
    match text.strip_prefix("0x") {
        Some(hex) => u32::from_str_radix(hex.trim_end_matches('u'), 16).ok().map(f64::from),
        None => text.trim_end_matches(['u', 'f']).parse().ok(),
    }
}
