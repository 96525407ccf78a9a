//! Selections: entries of the lists that segments are tested against, read at a variable index by selecting among all entries.
//!
//! *Theory.* A list in a uniform that is read at an index that varies by lane is read lane by lane: on a CPU this takes about 120
//! instructions per number for eight lanes. Reading all entries of a short list once for all lanes, and one selection per number and
//! entry, takes a few instructions.
//!
//! *Practice.* For CPUs `list[place]` becomes `list_at(place)`, which is generated for every list of up to [`FEW`] entries; a literal
//! index is not changed. Lists that are read once per ray, such as materials, gain less than their longer code costs in
//! compilation: the first pixel would take half as long again.

use std::fmt::Write as _;

use super::sources::{Known, Sources};
use super::tokens::{Splice, Tokens, whole_number};
use crate::model::shape::SOLIDS;

/// The largest number of entries for which selections are generated.
const FEW: u32 = 32;

/// A list in a uniform.
struct List {
    name: String,
    of: String,
    length: u32,
}

/// Replaces reads of short lists by selections. The lists of regions are not changed.
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

/// Returns the short lists that a text declares: `var<uniform> list: array<Entry, 3>;`.
fn lists(tokens: &Tokens, known: &Known) -> Vec<List> {
    let signs = [(0, "<"), (1, "uniform"), (2, ">"), (4, ":"), (5, "array"), (6, "<"), (8, ",")];
    let all = (0..tokens.len()).filter(|&i| tokens.before(i) == "var" && tokens.are(i, &signs)).filter_map(|i| {
        let (name, of) = (tokens.word(i + 3), tokens.word(i + 7));
        let length = known.number(tokens.word(i + 9)).filter(|length| is_met(name) && (1..=FEW).contains(length))?;
        Some(List { name: name.to_owned(), of: of.to_owned(), length })
    });
    all.collect()
}

/// Returns `true` for a list of shapes that segments are tested against.
fn is_met(name: &str) -> bool {
    SOLIDS
        .iter()
        .any(|solid| solid.lists.is_some() && [solid.opaque_list(), solid.sided_list()].iter().any(|list| list == name))
}

/// Returns the tokens of a unit with every read at a variable index replaced.
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
