//! The skies of the two sides of a wormhole: two modules with separate names.

use std::collections::BTreeSet;

use super::ProgramError;
use super::declarations::{Declaration, declarations};
use super::generated::unit;
use super::parts::part_tokens;
use super::unit::Unit;

/// The names of the near sky's bindings, which are equal in scenes with one sky.
const BOUND: [&str; 2] = ["sky", "Sky"];

/// Generates `near_sky_radiance` and `beyond_sky_radiance` from these two modules.
pub(super) fn two_skies(near: &str, beyond: &str) -> Result<[Unit; 2], ProgramError> {
    let near = renamed(near, "Near", &BOUND)?;
    let beyond = renamed(beyond, "Beyond", &[])?;
    Ok([unit("generated/near_sky.wgsl", near), unit("generated/beyond_sky.wgsl", beyond)])
}

/// Returns a module with a prefix before the names that it declares, except the names in `kept`.
fn renamed(part: &str, prefix: &str, kept: &[&str]) -> Result<String, ProgramError> {
    let found = part_tokens(&format!("{part}.wgsl")).ok_or_else(|| ProgramError::NoPart(part.to_owned()))?;
    let all = declarations(found).unwrap_or_default();
    let own: BTreeSet<&str> = all.iter().map(Declaration::name).filter(|name| !kept.contains(name)).collect();
    let new = |name: &str| {
        let is_type = name.starts_with(char::is_uppercase);
        if is_type { format!("{prefix}{name}") } else { format!("{}_{name}", prefix.to_lowercase()) }
    };
    let mut text = String::new();
    for declaration in &all {
        for (i, token) in declaration.tokens.0.iter().enumerate() {
            let is_own = declaration.names.contains(&i) && own.contains(&*token.word);
            text += &token.gap;
            text += &if is_own { new(&token.word) } else { token.word.to_string() };
        }
        text += "\n\n";
    }
    Ok(text)
}
