//! The linker: from parts to the one WGSL module of a pass.
//!
//! *Theory.* WGSL has no order at module scope, so that linking is concatenation: no preprocessor, no `#ifdef`. A pass is its
//! entry point and the declarations that it reaches by name, and nothing else: what a scene does not use is not in its
//! program. A scene with several kinds of region has a copy of the region's parts for each, the names suffixed, and a generated
//! switch wherever shared parts call one.
//!
//! *Practice.* About a millisecond a pass. Every line of the result knows the part and line it came from.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};

use super::block::Block;
use super::copies::with_region_copies;
use super::declarations::{Declaration, declarations};
use super::{Part, ProgramError};

/// A piece of WGSL with a name for errors: a part, or text generated for a scene.
#[derive(Debug, Clone)]
pub struct Unit {
    /// `law/sources.wgsl`, or `generated/shapes.wgsl`.
    pub file: Cow<'static, str>,
    /// The WGSL.
    pub text: Cow<'static, str>,
}

impl From<Part> for Unit {
    fn from(part: Part) -> Self {
        Self { file: part.file.into(), text: part.text.into() }
    }
}

/// What a scene's program is linked from.
#[derive(Debug, Clone, Default)]
pub struct Parts {
    /// Parts that all regions share.
    pub shared: Vec<Unit>,
    /// The parts of each kind of region; with more than one kind each gets a copy of its own.
    pub regions: Vec<Vec<Unit>>,
}

/// One pass's program.
#[derive(Debug, Clone)]
pub struct Linked {
    /// The entry point's name.
    pub entry: String,
    /// The WGSL module.
    pub source: String,
    /// For each line of the module (from 0) the part and its line.
    origins: Vec<Origin>,
}

#[derive(Debug, Clone)]
struct Origin {
    file: Cow<'static, str>,
    line: usize,
}

impl Linked {
    /// The parts that are in it, in order.
    #[must_use]
    pub fn parts(&self) -> Vec<&str> {
        let mut parts: Vec<&str> = self.origins.iter().map(|origin| &*origin.file).collect();
        parts.dedup();
        parts
    }

    /// The part and the line in it that line `line` (from 1) of the module came from.
    #[must_use]
    pub fn origin(&self, line: usize) -> (&str, usize) {
        self.origins.get(line.saturating_sub(1)).map_or(("(linked)", line), |origin| (&origin.file, origin.line))
    }
}

/// The program of the pass whose entry point is `entry`.
pub fn link(parts: &Parts, entry: &str) -> Result<Linked, ProgramError> {
    let units = with_region_copies(parts, entry)?;
    let mut all = Vec::new();
    for unit in &units {
        all.extend(declarations(&unit.text).into_iter().map(|d| (unit, d)));
    }
    let by_name = index(&all)?;
    let reached = reach(&all, &by_name, entry)?;
    let reached: Vec<&(&Unit, Declaration)> = reached.iter().map(|&i| &all[i]).collect();
    let block = Block::of(entry, &reached.iter().map(|(_, declaration)| declaration));
    let mut linked = Linked { entry: entry.to_owned(), source: String::new(), origins: Vec::new() };
    let made = Unit { file: "generated/uniforms.wgsl".into(), text: block.declaration().into() };
    if !made.text.is_empty() {
        linked.push(&made, 1, &format!("// ---- {}\n{}\n", made.file, made.text));
    }
    let mut file: &str = "";
    for (unit, declaration) in reached.iter().filter(|(_, declaration)| !block.replaces(declaration)) {
        if unit.file != file {
            file = &unit.file;
            linked.push(unit, 1, &format!("// ---- {file}\n"));
        }
        linked.push(unit, declaration.line, &block.rewritten(declaration));
        linked.push(unit, declaration.line, "\n");
    }
    Ok(linked)
}

impl Linked {
    fn push(&mut self, unit: &Unit, line: usize, text: &str) {
        for (i, content) in text.lines().enumerate() {
            self.source.push_str(content);
            self.source.push('\n');
            self.origins.push(Origin { file: unit.file.clone(), line: line + i });
        }
    }
}

fn index<'a>(all: &[(&'a Unit, Declaration<'a>)]) -> Result<HashMap<&'a str, usize>, ProgramError> {
    let mut by_name = HashMap::new();
    for (i, (unit, declaration)) in all.iter().enumerate() {
        if let Some(first) = by_name.insert(declaration.name, i) {
            let first: &(&Unit, Declaration) = &all[first];
            return Err(ProgramError::Twice {
                name: declaration.name.to_owned(),
                first: first.0.file.to_string(),
                second: unit.file.to_string(),
            });
        }
    }
    Ok(by_name)
}

/// The declarations that `entry` reaches, in the order of the parts.
fn reach(
    all: &[(&Unit, Declaration)],
    by_name: &HashMap<&str, usize>,
    entry: &str,
) -> Result<BTreeSet<usize>, ProgramError> {
    let start = *by_name.get(entry).ok_or_else(|| ProgramError::NoEntry(entry.to_owned()))?;
    let mut reached = BTreeSet::from([start]);
    let mut open = vec![start];
    while let Some(i) = open.pop() {
        for used in all[i].1.used().filter_map(|name| by_name.get(name)) {
            if reached.insert(*used) {
                open.push(*used);
            }
        }
    }
    Ok(reached)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{reflect, validated};

    fn unit(file: &'static str, text: &'static str) -> Unit {
        Unit { file: file.into(), text: text.into() }
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
        }
    }

    #[test]
    fn each_kind_of_region_has_its_own_copy() {
        let linked = link(&two_regions(), "entry").unwrap();
        validated(&linked).unwrap_or_else(|error| panic!("{error}\n{}", linked.source));
        for text in [
            "fn law_rate_0(",
            "fn law_rate_1(",
            "switch region",
            "return law_rate_1(x);",
            "law_1 = uniforms_entry.law_1;",
            "-law_1.a * x",
        ] {
            assert!(linked.source.contains(text), "{text}\n{}", linked.source);
        }
        let numbers: Vec<u32> = reflect(&linked).unwrap().bindings.iter().map(|binding| binding.number).collect();
        assert_eq!(numbers, [0, 9], "copies are members of the block");
    }

    #[test]
    fn uniforms_are_read_once() {
        let text = "const ONE: u32 = 1u;\nconst TWO: u32 = 2u;\nstruct A { a: array<vec4f, 3> }\n\
            struct Frame { zero: u32 }\n@group(0) @binding(3) var<uniform> frame: Frame;\n\
            @group(0) @binding(50) var<uniform> one: array<A, ONE>;\n\
            @group(0) @binding(51) var<uniform> two: array<A, TWO>;\n\
            fn law_derivative(x: f32) -> f32 {\n    return one[u32(two[frame.zero].a[0].x)].a[1].y + x;\n}\n";
        let parts =
            Parts { shared: vec![unit("pass/entry.wgsl", ENTRY), unit("law/a.wgsl", text)], regions: Vec::new() };
        let linked = link(&parts, "entry").unwrap();
        validated(&linked).unwrap_or_else(|error| panic!("{error}\n{}", linked.source));
        for text in [
            "fn entry() { read_uniforms();",
            "own_frame = frame;",
            "var<private> one: A;",
            "one = uniforms_entry.one[0];",
            "return one.a[1].y + x;",
        ] {
            assert!(linked.source.contains(text), "{text}\n{}", linked.source);
        }
        let with = |value: &str| {
            let text = text.replace("one[u32(two[frame.zero].a[0].x)]", value).into();
            let shared = vec![unit("pass/entry.wgsl", ENTRY), Unit { file: "law/a.wgsl".into(), text }];
            let linked = link(&Parts { shared, regions: Vec::new() }, "entry").unwrap();
            validated(&linked).unwrap_or_else(|error| panic!("{error}\n{}", linked.source));
            linked.source
        };
        let walked = with("two[0].a[2].x + two[frame.zero]");
        assert!(
            walked.contains("uniforms_entry.two[0].a[2].x + uniforms_entry.two[own_frame.zero].a[1].y"),
            "{walked}"
        );
        let written_out = with("two[0].a[2].x + two[1u]");
        for text in ["two_1 = uniforms_entry.two[1];", "return two_0.a[2].x + two_1.a[1].y + x;"] {
            assert!(written_out.contains(text), "{text}\n{written_out}");
        }
    }

    #[test]
    fn one_region_keeps_its_names() {
        let mut parts = two_regions();
        parts.regions.truncate(1);
        let linked = link(&parts, "entry").unwrap();
        assert!(linked.source.contains("fn law_derivative(") && !linked.source.contains("switch"));
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
            Parts { shared: vec![unit("pass/entry.wgsl", ENTRY), unit("law/slip.wgsl", slip)], regions: Vec::new() };
        let error = reflect(&link(&parts, "entry").unwrap()).unwrap_err().to_string();
        assert!(error.starts_with("shaders/law/slip.wgsl:6:16: "), "{error}");
    }

    #[test]
    fn names_are_declared_once() {
        let twice = unit("law/again.wgsl", ENTRY);
        let parts = Parts { shared: vec![unit("pass/entry.wgsl", ENTRY), twice], regions: Vec::new() };
        let error = link(&parts, "entry").unwrap_err().to_string();
        assert_eq!(error, "both pass/entry.wgsl and law/again.wgsl declare `out`");
    }
}
