//! The skies of two sides: their parts, each under names of its own.

use std::collections::BTreeSet;

use super::ProgramError;
use super::declarations::{Declaration, declarations};
use super::generated::unit;
use super::parts::part_tokens;
use super::unit::Unit;

/// What is bound for the near sky, as where there is no other.
const BOUND: [&str; 2] = ["sky", "Sky"];

/// `near_sky_radiance` and `beyond_sky_radiance`, of these two parts.
pub(super) fn two_skies(near: &str, beyond: &str) -> Result<[Unit; 2], ProgramError> {
    let near = renamed(near, "Near", &BOUND)?;
    let beyond = renamed(beyond, "Beyond", &[])?;
    Ok([unit("generated/near_sky.wgsl", near), unit("generated/beyond_sky.wgsl", beyond)])
}

/// A part with this before the names that it declares, except some.
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
