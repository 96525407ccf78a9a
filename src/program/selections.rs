//! Entries of the lists that segments are held against, at a place that is not known beforehand: chosen from all of them.
//!
//! *Theory.* A list in a uniform that is read at a place of each lane's own is read lane by lane: on a processor some hundred and twenty
//! instructions a number for eight lanes. All entries of a short list, each read once for all lanes, and one choice a number and
//! entry cost a few instructions.
//!
//! *Practice.* For processors `list[place]` becomes `list_at(place)`, which is written for every list of up to [`FEW`] entries; a place that is
//! written as a number stays. Lists that are read once a ray, such as materials, gain less from it than their many words cost the
//! driver's compiler: half again as long to the first pixel.

use std::borrow::Cow;
use std::fmt::Write as _;

use super::tokens::{Tokens, whole_number};
use super::unit::{Author, Parts, Unit};
use super::unroll::constants;
use crate::model::shape::SOLIDS;

/// Entries among which one is chosen.
const FEW: u32 = 32;

/// A list in a uniform.
struct List {
    name: String,
    of: String,
    length: u32,
}

/// The parts with their reads of short lists as choices. Regions' own lists are left alone.
pub(super) fn selected(mut parts: Parts) -> Parts {
    if !parts.device.is_processor {
        return parts;
    }
    let constants = constants(&parts.shared);
    let length = |word: &str| whole_number(word).or_else(|| constants.get(word).copied());
    let lists: Vec<List> = parts.shared.iter().flat_map(|unit| lists(&unit.text, &length)).collect();
    if lists.is_empty() {
        return parts;
    }
    parts.shared = parts.shared.into_iter().map(|unit| choosing(unit, &lists)).collect();
    let mut text = String::new();
    for List { name, of, length } in &lists {
        let _ = write!(text, "fn {name}_at(i: u32) -> {of} {{\n    var entry = {name}[0u];\n");
        for k in 1..*length {
            let _ = write!(text, "    if i == {k}u {{\n        entry = {name}[{k}u];\n    }}\n");
        }
        text += "    return entry;\n}\n\n";
    }
    parts.shared.push(Unit::generated("generated/entries.wgsl", text));
    parts
}

/// The short lists that a text declares: `var<uniform> list: array<Entry, 3>;`
fn lists(text: &str, length: &impl Fn(&str) -> Option<u32>) -> Vec<List> {
    let tokens = Tokens::of(text);
    let all = (0..tokens.len()).filter_map(|i| {
        let signs = [(0, "<"), (1, "uniform"), (2, ">"), (4, ":"), (5, "array"), (6, "<"), (8, ",")];
        let is_list = tokens.before(i) == "var" && signs.into_iter().all(|(k, sign)| tokens.word(i + k) == sign);
        let (name, of) = (tokens.word(i + 3), tokens.word(i + 7));
        let length =
            length(tokens.word(i + 9)).filter(|length| is_list && is_met(name) && (1..=FEW).contains(length))?;
        Some(List { name: name.to_owned(), of: of.to_owned(), length })
    });
    all.collect()
}

/// Is it a list of shapes, as segments meet them?
fn is_met(name: &str) -> bool {
    SOLIDS
        .iter()
        .any(|solid| solid.lists.is_some() && [solid.opaque_list(), solid.sided_list()].iter().any(|list| list == name))
}

/// The unit with every read at an unknown place replaced.
fn choosing(unit: Unit, lists: &[List]) -> Unit {
    if unit.author == Author::User || !lists.iter().any(|list| unit.text.contains(&*list.name)) {
        return unit;
    }
    let tokens = Tokens::of(&unit.text);
    let mut edits = Vec::new();
    for i in 0..tokens.len() {
        let is_list = tokens.before(i) != "." && tokens.word(i + 1) == "[" && !matches!(tokens.before(i), "&" | ":");
        let Some(list) = lists.iter().find(|list| is_list && list.name == tokens.word(i)) else { continue };
        let Some(end) = tokens.closing(i + 1) else { continue };
        if end == i + 3 && whole_number(tokens.word(i + 2)).is_some() {
            continue;
        }
        edits.push((tokens.range(i).start..tokens.range(i + 1).end, format!("{}_at(", list.name)));
        edits.push((tokens.range(end), ")".to_owned()));
    }
    edits.sort_by_key(|(range, _)| range.start);
    let mut text = String::new();
    let mut done = 0;
    for (range, new) in &edits {
        text += &unit.text[done..range.start];
        text += new;
        done = range.end;
    }
    text += &unit.text[done..];
    Unit { text: Cow::Owned(text), ..unit }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::DeviceProfile;

    #[test]
    fn reads_at_unknown_places_are_choices() {
        let text = "const N: u32 = 2u;\nstruct A { b: f32 }\n@group(0) @binding(7) var<uniform> sphere_list: array<A, N>;\n\
                    @group(0) @binding(8) var<uniform> box_list: array<A, 33>;\n\
                    @group(0) @binding(9) var<uniform> others: array<A, 2>;\n\
                    fn f(i: u32) -> f32 {\n    return sphere_list[min(i, n[0])].b + sphere_list[1u].b + box_list[i].b + \
                    a.sphere_list[i] + others[i].b;\n}\n";
        let device = DeviceProfile::cpu(8);
        let parts = Parts { shared: vec![Unit::generated("a.wgsl", text.to_owned())], device, ..Parts::default() };
        let chosen = selected(parts);
        let [own, entries] = &chosen.shared[..] else { panic!("{}", chosen.shared.len()) };
        let expected = "return sphere_list_at(min(i, n[0])).b + sphere_list[1u].b + box_list[i].b + a.sphere_list[i] + \
                        others[i].b;";
        assert!(own.text.contains(expected), "{}", own.text);
        assert_eq!(
            entries.text,
            "fn sphere_list_at(i: u32) -> A {\n    var entry = sphere_list[0u];\n    if i == 1u {\n        \
             entry = sphere_list[1u];\n    }\n    return entry;\n}\n\n"
        );
    }
}
