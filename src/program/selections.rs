//! Entries of the lists that segments are held against, at a place that is not known beforehand: chosen from all of them.
//!
//! *Theory.* A list in a uniform that is read at a place of each lane's own is read lane by lane: on a processor some hundred and twenty
//! instructions a number for eight lanes. All entries of a short list, each read once for all lanes, and one choice a number and
//! entry cost a few instructions.
//!
//! *Practice.* For processors `list[place]` becomes `list_at(place)`, which is written for every list of up to [`FEW`] entries; a place that is
//! written as a number stays. Lists that are read once a ray, such as materials, gain less from it than their many words cost the
//! driver's compiler: half again as long to the first pixel.

use std::fmt::Write as _;

use super::sources::{Known, Sources};
use super::tokens::{Splice, Tokens, whole_number};
use crate::model::shape::SOLIDS;

/// Entries among which one is chosen.
const FEW: u32 = 32;

/// A list in a uniform.
struct List {
    name: String,
    of: String,
    length: u32,
}

/// Writes reads of short lists as choices. Regions' own lists are left alone.
pub(super) fn select(sources: &mut Sources) {
    let known = sources.known();
    let lists: Vec<List> = sources.shared.iter().flat_map(|source| lists(&source.tokens, &known)).collect();
    if lists.is_empty() {
        return;
    }
    sources.edit(|tokens, _| choosing(tokens, &lists));
    let mut text = String::new();
    for List { name, of, length } in &lists {
        let _ = write!(text, "fn {name}_at(i: u32) -> {of} {{\n    var entry = {name}[0u];\n"); // writing to a String cannot fail
        for k in 1..*length {
            let _ = write!(text, "    if i == {k}u {{\n        entry = {name}[{k}u];\n    }}\n");
        }
        text += "    return entry;\n}\n\n";
    }
    sources.add("generated/entries.wgsl", text);
}

/// The short lists that a text declares: `var<uniform> list: array<Entry, 3>;`
fn lists(tokens: &Tokens, known: &Known) -> Vec<List> {
    let signs = [(0, "<"), (1, "uniform"), (2, ">"), (4, ":"), (5, "array"), (6, "<"), (8, ",")];
    let all = (0..tokens.len()).filter(|&i| tokens.before(i) == "var" && tokens.are(i, &signs)).filter_map(|i| {
        let (name, of) = (tokens.word(i + 3), tokens.word(i + 7));
        let length = known.number(tokens.word(i + 9)).filter(|length| is_met(name) && (1..=FEW).contains(length))?;
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

/// The tokens of a unit with every read at an unknown place replaced.
fn choosing<'a>(tokens: Tokens<'a>, lists: &[List]) -> Tokens<'a> {
    let mut splices: Vec<Splice> = Vec::new();
    for i in 0..tokens.len() {
        let is_list = tokens.word(i + 1) == "[" && !matches!(tokens.before(i), "." | "&" | ":");
        let Some(list) = lists.iter().find(|list| is_list && list.name == tokens.word(i)) else { continue };
        let Some(end) = tokens.closing(i + 1) else { continue };
        if end == i + 3 && whole_number(tokens.word(i + 2)).is_some() {
            continue;
        }
        splices.push((i..i + 2, tokens.replacement(i, &format!("{}_at(", list.name))));
        splices.push((end..end + 1, Tokens::written_at(")", tokens.origin(end))));
    }
    tokens.spliced(splices)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{Parts, Unit};

    #[test]
    fn reads_at_unknown_places_are_choices() {
        let text = "const N: u32 = 2u;\nstruct A { b: f32 }\n@group(0) @binding(7) var<uniform> sphere_list: array<A, N>;\n\
                    @group(0) @binding(8) var<uniform> box_list: array<A, 33>;\n\
                    @group(0) @binding(9) var<uniform> others: array<A, 2>;\n\
                    fn f(i: u32) -> f32 {\n    return sphere_list[min(i, n[0])].b + sphere_list[1u].b + box_list[i].b + \
                    a.sphere_list[i] + others[i].b;\n}\n";
        let parts = Parts { shared: vec![Unit::generated("a.wgsl", text.to_owned())], ..Parts::default() };
        let chosen = Sources::edited(&parts, select);
        let [own, entries] = &chosen[..] else { panic!("{}", chosen.len()) };
        let expected = "return sphere_list_at(min(i, n[0])).b + sphere_list[1u].b + box_list[i].b + a.sphere_list[i] + \
                        others[i].b;";
        assert!(own.contains(expected), "{own}");
        assert_eq!(
            entries,
            "fn sphere_list_at(i: u32) -> A {\n    var entry = sphere_list[0u];\n    if i == 1u {\n        \
             entry = sphere_list[1u];\n    }\n    return entry;\n}"
        );
    }
}
