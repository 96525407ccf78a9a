//! The linker, which builds one WGSL module for each pass from the modules of a scene.
//!
//! *Theory.* WGSL has no order at module scope, so a pass consists of its entry point and the declarations that it reaches by name.
//! Its program contains nothing that the scene does not use.
//!
//! Modules are read as tokens with source locations, and edited as tokens ([`link_all`] lists all edits in order): `short_lists` moves
//! short lists into uniforms; `fold` decides branches on features; `unroll` unrolls short loops; `loop_counts` counts the iterations of
//! the others, for devices with a loop budget; `selections` turns reads of short lists into selections, for CPUs. The tokens are then split
//! into declarations: `copies` makes a copy of a region's declarations for each kind of region, with a suffix, and a switch wherever shared
//! modules call one; `inline` inlines functions that only pass on a value. For each pass, `lower` joins the uniforms in one block, and
//! `bindings` the per-pixel values in one buffer; all bindings get numbers. A pass is written in reading order: the entry point, then the
//! functions that it calls, then their callees, file by file.
//!
//! *Practice.* Linking takes at most about a millisecond per pass, because the edits of modules are done once for all passes.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use super::bindings::{Numbers, Pixels, is_of_pixels};
use super::copies::with_region_copies;
use super::declarations::{Declaration, declarations};
use super::fold::folded;
use super::inline::inlined;
use super::linked::{LinkedProgram, refuse};
use super::location::Location;
use super::loop_counts::counted;
use super::lower::Lowering;
use super::selections::select;
use super::short_lists::in_uniforms;
use super::sources::Sources;
use super::tokens::Tokens;
use super::unit::{Author, Parts, Unit};
use super::unroll::unrolled;
use super::{DeviceProfile, ProgramError};

/// Links the program of the pass with the entry point `entry`.
///
/// # Errors
///
/// Returns the errors of [`link_all`].
pub fn link(parts: &Parts, entry: &str) -> Result<LinkedProgram, ProgramError> {
    link_all(parts, &[entry]).map(|mut all| all.remove(0))
}

/// Links the programs of several passes, in order, each named by its entry point.
///
/// # Errors
///
/// Returns an error if no module declares an entry point, two modules declare one name, or a module uses a reserved name.
pub fn link_all(parts: &Parts, entries: &[&str]) -> Result<Vec<LinkedProgram>, ProgramError> {
    let mut sources = Sources::of(parts);
    sources.edit(|tokens, _| in_uniforms(tokens, &parts.lengths));
    sources.edit(folded);
    sources.edit(unrolled);
    if parts.device.loop_budget.is_some() {
        sources.edit_all(counted);
    }
    if parts.device.is_processor {
        select(&mut sources);
    }
    let (all, units) = with_region_copies(sources)?;
    let all = inlined(all, &units);
    let by_name = index(&all, &units)?;
    let reached = entries.iter().map(|entry| reach(&all, &by_name, entry)).collect::<Result<Vec<_>, _>>()?;
    let kept: BTreeSet<usize> = reached.iter().flatten().copied().filter(|&i| is_of_pixels(&all[i])).collect();
    let pixels = Pixels::of(kept.iter().map(|&i| &all[i]));
    let units = Arc::new([units, vec![Unit::generated("generated/bindings.wgsl", String::new())]].concat());
    let pass = |(entry, mut reached): (&&str, BTreeSet<usize>)| {
        let keeps = !reached.is_disjoint(&kept);
        if keeps {
            // A pass that uses one per-pixel value binds the struct of all values, and needs the types of its members.
            extend(&mut reached, kept.iter().copied().collect(), &all, &by_name);
            reached.retain(|i| !kept.contains(i));
        }
        let rank = reading_order(&all, &by_name, entry);
        let reached: Vec<&Declaration> = reached.into_iter().map(|i| &all[i]).collect();
        let nothing = Pixels::default();
        pass(&units, (&reached, &rank), entry, &parts.device, if keeps { &pixels } else { &nothing })
    };
    entries.iter().zip(reached).map(pass).collect()
}

/// Lowers and writes the declarations that an entry point reaches.
fn pass(
    units: &Arc<Vec<Unit>>,
    (reached, rank): (&[&Declaration], &HashMap<usize, usize>),
    entry: &str,
    device: &DeviceProfile,
    pixels: &Pixels,
) -> Result<LinkedProgram, ProgramError> {
    let lowering = Lowering::of(entry, reached, device);
    let made = lowering.made().into_iter().chain(pixels.made()).collect();
    reached.iter().try_for_each(|declaration| refuse(declaration, &made, units))?;
    let mut numbers = Numbers::beside(reached.iter().copied());
    let made = lowering.declaration() + &pixels.declaration();
    let made = declarations(Tokens::made(&made, units.len() - 1)).unwrap_or_default();
    let own = reached.iter().filter(|declaration| !lowering.replaces(declaration)).map(|declaration| {
        let splices = [lowering.splices(declaration), pixels.splices(declaration)].concat();
        (*declaration).clone().spliced(splices)
    });
    let mut numbered: Vec<_> = made.into_iter().chain(own).map(|declaration| numbers.given(declaration)).collect();
    // Generated declarations come last.
    numbered.sort_by_key(|declaration| rank.get(&declaration.origin().unit).copied().unwrap_or(usize::MAX));
    let mut linked = LinkedProgram::new(entry, units.clone());
    linked.push(&numbered);
    Ok(linked)
}

pub(super) fn index<'d>(all: &'d [Declaration], units: &[Unit]) -> Result<HashMap<&'d str, usize>, ProgramError> {
    let mut by_name = HashMap::new();
    for (i, declaration) in all.iter().enumerate() {
        if let Some(first) = by_name.insert(declaration.name(), i) {
            let mut places = [declaration.origin(), all[first].origin()];
            // Of two declarations, the error is in the user's.
            places.sort_by_key(|origin| units[origin.unit].author != Author::User);
            let [at_fault, other] = places;
            return Err(ProgramError::Twice {
                place: Location::of(units, at_fault),
                name: declaration.name().to_owned(),
                other: units[other.unit].shown(),
            });
        }
    }
    Ok(by_name)
}

/// Returns the declarations that `entry` reaches, in the order of the modules.
pub(super) fn reach(
    all: &[Declaration],
    by_name: &HashMap<&str, usize>,
    entry: &str,
) -> Result<BTreeSet<usize>, ProgramError> {
    let start = *by_name.get(entry).ok_or_else(|| ProgramError::NoEntry(entry.to_owned()))?;
    let mut reached = BTreeSet::from([start]);
    extend(&mut reached, vec![start], all, by_name);
    Ok(reached)
}

/// Adds the declarations that the open ones reach.
fn extend(reached: &mut BTreeSet<usize>, mut open: Vec<usize>, all: &[Declaration], by_name: &HashMap<&str, usize>) {
    while let Some(i) = open.pop() {
        for used in all[i].used().filter_map(|name| by_name.get(name)) {
            if reached.insert(*used) {
                open.push(*used);
            }
        }
    }
}

/// Returns the files that `entry` reaches, by unit, with their rank in the order of use: breadth first.
fn reading_order(all: &[Declaration], by_name: &HashMap<&str, usize>, entry: &str) -> HashMap<usize, usize> {
    let mut order: Vec<usize> = by_name.get(entry).copied().into_iter().collect();
    let mut seen: BTreeSet<usize> = order.iter().copied().collect();
    let mut rank = HashMap::new();
    let mut next = 0;
    while let Some(declaration) = order.get(next).map(|&i| &all[i]) {
        let after = rank.len();
        rank.entry(declaration.origin().unit).or_insert(after);
        order.extend(declaration.used().filter_map(|name| by_name.get(name).copied()).filter(|i| seen.insert(*i)));
        next += 1;
    }
    rank
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{reflect, validated};

    fn unit(file: &'static str, text: &'static str) -> Unit {
        Unit::user(file, text)
    }

    const ENTRY: &str = "@group(0) @binding(0) var<storage, read_write> out: array<f32>;\n\
        var<private> region: u32;\n\
        @compute @workgroup_size(1) fn entry() {\n    out[0] = law_derivative(1.0);\n}\n";

    fn two_regions() -> Parts {
        let strength = "struct Law { a: f32 }\n@group(0) @binding(50) var<uniform> law: Law;\n";
        Parts {
            shared: vec![unit("pass/entry.wgsl", ENTRY)],
            regions: vec![
                vec![
                    unit("law/weak.wgsl", strength),
                    unit("law/a.wgsl", "fn law_derivative(x: f32) -> f32 { return law.a * x; }\n"),
                ],
                vec![
                    unit("law/strong.wgsl", strength),
                    unit("law/b.wgsl", "fn law_derivative(x: f32) -> f32 { return -law.a * x; }\n"),
                ],
            ],
            device: DeviceProfile::cpu(8),
            ..Parts::default()
        }
    }

    #[test]
    fn each_kind_of_region_has_its_own_copy() {
        let linked = link(&two_regions(), "entry").unwrap();
        validated(&linked).unwrap_or_else(|error| panic!("{error}\n{}", linked.source));
        for text in [
            "fn law_derivative_0(",
            "fn law_derivative_1(",
            "switch region",
            "return law_derivative_1(x);",
            "law_1 = uniforms_entry.law_1;",
            "-law_1.a * x",
        ] {
            assert!(linked.source.contains(text), "{text}\n{}", linked.source);
        }
        let numbers: Vec<u32> = reflect(&linked).unwrap().bindings.iter().map(|binding| binding.number).collect();
        assert_eq!(numbers, [0, 500], "copies are members of the block");
    }

    #[test]
    fn one_region_keeps_its_names() {
        let mut parts = two_regions();
        parts.regions.truncate(1);
        let linked = link(&parts, "entry").unwrap();
        assert!(linked.source.contains("fn law_derivative(") && !linked.source.contains("switch"));
    }

    #[test]
    fn a_pass_is_written_from_its_entry_point_down() {
        let parts = Parts {
            shared: vec![
                unit("a.wgsl", "fn deep(x: f32) -> f32 {\n    return x + x;\n}\n"),
                unit("b.wgsl", "fn law_derivative(x: f32) -> f32 {\n    return x * deep(x);\n}\n"),
                unit("pass/entry.wgsl", ENTRY),
            ],
            ..Parts::default()
        };
        assert_eq!(link(&parts, "entry").unwrap().parts(), ["pass/entry.wgsl", "b.wgsl", "a.wgsl"]);
    }

    #[test]
    fn only_functions_over_shared_types_can_be_chosen_between() {
        let mut parts = two_regions();
        for region in &mut parts.regions {
            region.push(unit("law/k.wgsl", "const K: f32 = 1.0;\n"));
        }
        parts.shared.push(unit("more.wgsl", "fn more() -> f32 { return K; }\n"));
        let error = link(&parts, "entry").unwrap_err().to_string();
        assert!(error.contains("`K` has a copy for each kind of region"), "{error}");
    }

    #[test]
    fn errors_name_the_part_and_its_own_line() {
        let slip = "// A law with a slip.\n\nfn unused() {}\n\nfn law_derivative(x: f32) -> f32 {\n    return x * nothing;\n}\n";
        let parts =
            Parts { shared: vec![unit("pass/entry.wgsl", ENTRY), unit("law/slip.wgsl", slip)], ..Parts::default() };
        let error = reflect(&link(&parts, "entry").unwrap()).unwrap_err().to_string();
        assert!(error.starts_with("law/slip.wgsl:6:16: "), "{error}");
    }

    #[test]
    fn what_cannot_be_read_is_refused() {
        let parts = Parts {
            shared: vec![unit("pass/entry.wgsl", ENTRY), unit("law/a.wgsl", "\nfn f() { if true {}\n")],
            ..Parts::default()
        };
        let error = link(&parts, "entry").unwrap_err().to_string();
        assert_eq!(error, "law/a.wgsl:2:1: `fn f` is not closed: add the missing `}` or `;`");
    }

    #[test]
    fn a_users_own_file_is_at_fault() {
        let built_in = Unit::from(crate::program::part("real/math").unwrap());
        let name = declarations(Tokens::of(&built_in.text)).unwrap()[0].name().to_owned();
        let own = Unit::user("my/law.wgsl", format!("// Mine.\nfn {name}() {{}}\n"));
        for shared in [vec![built_in.clone(), own.clone()], vec![own.clone(), built_in.clone()]] {
            let error = link(&Parts { shared, ..Parts::default() }, "entry").unwrap_err().to_string();
            assert_eq!(error, format!("my/law.wgsl:2:4: `{name}` is already declared in shaders/real/math.wgsl"));
        }
    }

    #[test]
    fn names_are_declared_once() {
        let twice = unit("law/again.wgsl", ENTRY);
        let parts = Parts { shared: vec![unit("pass/entry.wgsl", ENTRY), twice], ..Parts::default() };
        let error = link(&parts, "entry").unwrap_err().to_string();
        assert_eq!(error, "law/again.wgsl:1:48: `out` is already declared in pass/entry.wgsl");
    }

    #[test]
    fn copies_are_told_apart_however_they_are_written() {
        let linked = |text: &str| {
            let mut parts = two_regions();
            parts.shared[0].text = ENTRY.replace("law_derivative(1.0)", "law_derivative(1.0, vec2f(2.0))").into();
            for region in &mut parts.regions {
                region[1] = Unit::user("law/a.wgsl", text.to_owned());
            }
            link(&parts, "entry").and_then(|linked| reflect(&linked).map(|_| linked.source))
        };
        let plain = "var table: texture_2d<f32>;\n\
            fn law_derivative(x: f32, y: vec2<f32>) -> f32 {\n    return law.a * x * y.x + textureLoad(table, vec2u(), 0).x;\n}\n";
        let written = linked(plain).unwrap();
        for text in [
            "@binding(501) var table_0",
            "@binding(502) var table_1",
            "fn law_derivative(x: f32, y: vec2<f32>) -> f32 {",
        ] {
            assert!(written.contains(text), "{text}\n{written}");
        }
        for (from, to) in [
            ("(x: f32, y: vec2<f32>)", "(\n    x /* , */ :f32, // first\n    y: vec2 <f32,>,\n)"),
            ("(x: f32, y: vec2<f32>) -> f32", "(x: f32,y: vec2<f32>)->f32"),
        ] {
            let other = linked(&plain.replace(from, to)).unwrap();
            let switch = |text: &str| {
                let (_, from) = text.split_once("// ---- generated/kinds.wgsl")?;
                from.split("// ----").next().map(str::to_owned)
            };
            assert!(switch(&written).is_some_and(|own| switch(&other) == Some(own)), "{to}\n{other}");
        }
        // A parameter with the selector's name does not hide it.
        assert!(linked(&plain.replace("(x:", "(region:").replace("* x", "* region")).is_ok());
        let slip = linked(&plain.replace("y.x", "y.q")).unwrap_err().to_string();
        assert!(slip.starts_with("law/a.wgsl:3:26: "), "{slip}");
        let taken = linked(&plain.replace("(x:", "(law_0:")).unwrap_err().to_string();
        assert!(taken.starts_with("law/a.wgsl:2:19: the name `law_0` is reserved"), "{taken}");
    }
}
