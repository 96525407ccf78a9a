//! Copies of the parts of a region, where a scene has several kinds of them.
//!
//! *Theory.* Every name that a region's parts declare gets the number of its kind for a suffix; for each
//! function that shared parts call there is one more of its old name, which switches between the copies.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use super::ProgramError;
use super::declarations::{Declaration, declarations};
use super::linked::{Copy, Edit, Place};
use super::unit::{Parts, Unit};

/// The private variable that says which kind of region a ray is in.
const SELECTOR: &str = "region";

/// A unit's declarations.
pub(super) fn split(unit: &Unit) -> Result<Vec<Declaration<'_>>, ProgramError> {
    declarations(&unit.text).map_err(|slip| ProgramError::invalid(Place::of(unit, slip.at), slip.message))
}

/// All the parts that passes are linked from.
pub(super) fn with_region_copies(parts: &Parts) -> Result<Vec<Copy>, ProgramError> {
    let as_it_is = |unit: &Unit| Copy::new(unit, &[]);
    let mut copies: Vec<Copy> = parts.shared.iter().map(as_it_is).collect();
    if let [only] = parts.regions.as_slice() {
        copies.extend(only.iter().map(as_it_is));
        return Ok(copies);
    }
    let mut regions = Vec::new();
    for region in &parts.regions {
        regions.push(region.iter().map(|unit| Ok((unit, split(unit)?))).collect::<Result<Vec<_>, ProgramError>>()?);
    }
    for (k, region) in regions.iter().enumerate() {
        let own: BTreeSet<&str> = region.iter().flat_map(|(_, found)| found).map(|d| d.name).collect();
        let made = own.iter().map(|name| format!("{name}_{k}")).collect();
        for (unit, found) in region {
            if let Some((at, name)) = found.iter().find_map(|declaration| declaration.mentions(&made)) {
                return Err(ProgramError::Reserved { place: Place::of(unit, at), name: name.to_owned() });
            }
            copies.push(Copy::new(unit, &found.iter().flat_map(|d| copy_edits(d, k, &own)).collect::<Vec<_>>()));
        }
    }
    if let Some(first) = regions.first() {
        let own: Vec<_> = first.iter().flat_map(|(unit, found)| found.iter().map(move |d| (*unit, d))).collect();
        copies.push(Copy::new(&region_switches(parts, &own)?, &[]));
    }
    Ok(copies)
}

/// What tells copy `k` from the original: suffixes on the names of its region.
fn copy_edits(declaration: &Declaration, k: usize, own: &BTreeSet<&str>) -> Vec<Edit> {
    let tokens = &declaration.tokens;
    let named = declaration.names.iter().filter(|&&i| own.contains(tokens.word(i)));
    let at = declaration.at;
    let edit = |&i: &usize| {
        let range = tokens.range(i);
        (range.start + at..range.end + at, format!("{}_{k}", tokens.word(i)))
    };
    named.map(edit).collect()
}

/// One function for every name of the regions that shared parts use, which picks the copy by the ray's region.
fn region_switches(parts: &Parts, first: &[(&Unit, &Declaration)]) -> Result<Unit, ProgramError> {
    let own: BTreeMap<&str, &(&Unit, &Declaration)> = first.iter().map(|pair| (pair.1.name, pair)).collect();
    let mut wanted = BTreeSet::new();
    for unit in &parts.shared {
        wanted.extend(split(unit)?.iter().flat_map(Declaration::used).filter_map(|name| Some(own.get(name)?.1.name)));
    }
    let mut text = String::new();
    for name in wanted {
        let (unit, declaration) = own[name];
        let refused = || ProgramError::NotSwitchable { place: Place::of(unit, declaration.at), name: name.to_owned() };
        let switch = switch(declaration, parts.regions.len(), |name| own.contains_key(name)).ok_or_else(refused)?;
        let _ = write!(text, "\n{switch}"); // writing to a String cannot fail
    }
    Ok(Unit::generated("generated/kinds.wgsl", text))
}

/// A function of the declaration's name and signature that calls its copies; none where a type has copies itself.
fn switch(declaration: &Declaration, kinds: usize, has_copies: impl Fn(&str) -> bool) -> Option<String> {
    let (tokens, name) = (&declaration.tokens, declaration.name);
    let signature = declaration.signature()?;
    let types = signature.parameters.iter().map(|parameter| &parameter.ty).chain(&signature.result);
    if types.flat_map(Clone::clone).any(|i| has_copies(tokens.word(i))) {
        return None;
    }
    // A parameter would hide the selector.
    let renamed = |i: usize| if tokens.word(i) == SELECTOR { "own_region" } else { tokens.word(i) };
    let names: Vec<&str> = signature.parameters.iter().map(|parameter| renamed(parameter.name)).collect();
    let parameters: Vec<String> = (names.iter().zip(&signature.parameters))
        .map(|(name, parameter)| format!("{name}: {}", tokens.written(parameter.ty.clone())))
        .collect();
    let (result, back) = match signature.result {
        Some(ty) => (format!(" -> {}", tokens.written(ty)), "return "),
        None => (String::new(), ""),
    };
    let call = |k: usize| format!("{back}{name}_{k}({});", names.join(", "));
    let mut text = format!("fn {name}({}){result} {{\n    switch {SELECTOR} {{\n", parameters.join(", "));
    for k in 0..kinds - 1 {
        let _ = writeln!(text, "        case {k}u: {{\n            {}\n        }}", call(k));
    }
    let _ = writeln!(text, "        default: {{\n            {}\n        }}\n    }}\n}}", call(kinds - 1));
    Some(text)
}
