//! Copies of the modules of a region, for scenes with several kinds of regions.
//!
//! *Theory.* Every name that a region's modules declare gets the number of its kind as a suffix. For each function that shared
//! modules call, one more function of the original name switches between the copies.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::declarations::{Declaration, declarations};
use super::location::Location;
use super::sources::{Source, Sources};
use super::unit::Unit;
use super::{ProgramError, linked};

/// The private variable that stores the kind of region that a ray is in.
const SELECTOR: &str = "region";

/// Returns all declarations from which passes are linked, and the units that contain them.
pub(super) fn with_region_copies(sources: Sources) -> Result<(Vec<Declaration>, Vec<Unit>), ProgramError> {
    let Sources { mut units, shared, regions } = sources;
    let mut all = split(shared, &units)?;
    let regions = regions.into_iter().map(|region| split(region, &units)).collect::<Result<Vec<_>, _>>()?;
    if regions.len() < 2 {
        all.extend(regions.into_iter().flatten());
        return Ok((all, units));
    }
    let switches = region_switches(&all, &regions, &units)?;
    for (k, region) in regions.into_iter().enumerate() {
        let own: BTreeSet<String> = region.iter().map(|declaration| declaration.name().to_owned()).collect();
        let made = own.iter().map(|name| format!("{name}_{k}")).collect();
        for declaration in region {
            linked::refuse(&declaration, &made, &units)?;
            all.push(renamed(declaration, |name| own.contains(name).then(|| format!("{name}_{k}"))));
        }
    }
    all.extend(split(vec![Source::made(&switches, units.len())], &units)?);
    units.push(Unit::generated("generated/kinds.wgsl", switches));
    Ok((all, units))
}

/// Splits units into declarations.
fn split<'a>(sources: Vec<Source<'a>>, units: &[Unit]) -> Result<Vec<Declaration<'a>>, ProgramError> {
    let found = sources.into_iter().map(|source| declarations(source.tokens));
    let all = found.collect::<Result<Vec<_>, _>>();
    let all = all.map_err(|slip| ProgramError::invalid(Location::of(units, slip.origin), slip.message))?;
    Ok(all.into_iter().flatten().collect())
}

/// Returns the declaration with the module-scope names that `name` changes.
pub(super) fn renamed(mut declaration: Declaration<'_>, name: impl Fn(&str) -> Option<String>) -> Declaration<'_> {
    for &i in &declaration.names {
        if let Some(name) = name(&declaration.tokens.0[i].word) {
            declaration.tokens.0[i].word = name.into();
        }
    }
    declaration
}

/// Generates a function for every name of the regions that shared modules use; it selects the copy by the ray's region.
fn region_switches(
    shared: &[Declaration],
    regions: &[Vec<Declaration>],
    units: &[Unit],
) -> Result<String, ProgramError> {
    let own = |name: &str| regions[0].iter().find(|declaration| declaration.name() == name);
    let wanted: BTreeSet<&str> = shared.iter().flat_map(Declaration::used).filter(|name| own(name).is_some()).collect();
    let mut text = String::new();
    for declaration in wanted.into_iter().filter_map(own) {
        let refused = || ProgramError::NotSwitchable {
            place: Location::of(units, declaration.origin()),
            name: declaration.name().to_owned(),
        };
        let switch = switch(declaration, regions.len(), |name| own(name).is_some()).ok_or_else(refused)?;
        let _ = write!(text, "\n{switch}"); // writing to a String cannot fail
    }
    Ok(text)
}

/// Generates a function with the declaration's name and signature that calls its copies; `None` if a type in it has copies itself.
fn switch(declaration: &Declaration, kinds: usize, has_copies: impl Fn(&str) -> bool) -> Option<String> {
    let (tokens, name) = (&declaration.tokens, declaration.name());
    let signature = declaration.signature()?;
    let types = signature.parameters.iter().map(|parameter| &parameter.ty).chain(&signature.result);
    if types.flat_map(Clone::clone).any(|i| has_copies(tokens.word(i))) {
        return None;
    }
    // A parameter of this name would hide the selector.
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
