//! Copies of the parts of a region, where a scene has several kinds of them.
//!
//! *Theory.* Every name that a region's parts declare gets the number of its kind for a suffix, and bindings of its own; for each
//! function that shared parts call there is one more of its old name, which switches between the copies.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use super::ProgramError;
use super::declarations::{Declaration, declarations};
use super::link::{Parts, Unit};

/// How far apart the bindings of region copies are.
const COPY_BINDINGS: u32 = 200;

/// All the parts that `entry` is linked from.
pub(super) fn with_region_copies(parts: &Parts, entry: &str) -> Result<Vec<Unit>, ProgramError> {
    let mut units = parts.shared.clone();
    if let [only] = parts.regions.as_slice() {
        units.extend(only.iter().cloned());
        return Ok(units);
    }
    for (k, region) in parts.regions.iter().enumerate() {
        let own: BTreeSet<&str> = region.iter().flat_map(|unit| declarations(&unit.text)).map(|d| d.name).collect();
        units.extend(region.iter().map(|unit| copied(unit, k, &own)));
    }
    if !parts.regions.is_empty() {
        units.push(region_switches(parts, entry)?);
    }
    Ok(units)
}

/// The part with every name of its region suffixed, and bindings of its own.
fn copied(unit: &Unit, k: usize, own: &BTreeSet<&str>) -> Unit {
    let mut text = String::new();
    let mut at = 0;
    for declaration in declarations(&unit.text) {
        let base = declaration.text.as_ptr() as usize - unit.text.as_ptr() as usize;
        for range in &declaration.identifiers {
            if own.contains(&declaration.text[range.clone()]) {
                text.push_str(&unit.text[at..base + range.end]);
                let _ = write!(text, "_{k}"); // writing to a String cannot fail
                at = base + range.end;
            }
        }
    }
    text.push_str(&unit.text[at..]);
    Unit { file: unit.file.clone(), text: with_shifted_bindings(&text, k).into() }
}

fn with_shifted_bindings(text: &str, k: usize) -> String {
    const BINDING: &str = "@binding(";
    let mut pieces = text.split(BINDING);
    let mut shifted = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let digits = piece.find(')').unwrap_or(0);
        let number = piece[..digits].parse::<u32>().unwrap_or(0);
        let _ = write!(shifted, "{BINDING}{}", number + COPY_BINDINGS * (k as u32 + 1));
        shifted.push_str(&piece[digits..]);
    }
    shifted
}

/// One function for every name of the regions that shared parts use, which picks the copy by the private variable `region`.
fn region_switches(parts: &Parts, entry: &str) -> Result<Unit, ProgramError> {
    let first: Vec<(&Unit, Declaration)> =
        parts.regions[0].iter().flat_map(|unit| declarations(&unit.text).into_iter().map(move |d| (unit, d))).collect();
    let own: BTreeMap<&str, &(&Unit, Declaration)> = first.iter().map(|pair| (pair.1.name, pair)).collect();
    let shared: Vec<Declaration> = parts.shared.iter().flat_map(|unit| declarations(&unit.text)).collect();
    let wanted: BTreeSet<&str> =
        shared.iter().flat_map(Declaration::used).chain([entry]).filter(|name| own.contains_key(name)).collect();
    let mut text = String::new();
    for name in wanted {
        let (unit, declaration) = own[name];
        let refused = || ProgramError::NotSwitchable { file: unit.file.to_string(), name: name.to_owned() };
        let signature = declaration.text.find("fn ").zip(declaration.text.find('{'));
        let (from, to) = signature.filter(|_| declaration.keyword == "fn").ok_or_else(refused)?;
        let signature = declaration.text[from..to].trim();
        if declarations(&format!("{signature} {{}}"))
            .iter()
            .flat_map(Declaration::used)
            .any(|n| n != name && own.contains_key(n))
        {
            return Err(refused());
        }
        let _ = write!(text, "\n{}", switch(signature, name, parts.regions.len()));
    }
    Ok(Unit { file: "generated/kinds.wgsl".into(), text: text.into() })
}

fn switch(signature: &str, name: &str, kinds: usize) -> String {
    let parameters =
        signature.split_once('(').map_or("", |(_, rest)| rest.rsplit_once(')').map_or("", |(inside, _)| inside));
    let arguments: Vec<&str> =
        parameters.split(',').filter_map(|p| p.split(':').next()).map(str::trim).filter(|p| !p.is_empty()).collect();
    let call = |k: usize| {
        let call = format!("{name}_{k}({})", arguments.join(", "));
        if signature.contains("->") { format!("return {call};") } else { format!("{call};") }
    };
    let mut text = format!("{signature} {{\n    switch region {{\n");
    for k in 0..kinds - 1 {
        let _ = writeln!(text, "        case {k}u: {{\n            {}\n        }}", call(k));
    }
    let _ = writeln!(text, "        default: {{\n            {}\n        }}\n    }}\n}}", call(kinds - 1));
    text
}
