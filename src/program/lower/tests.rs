//! Tests of lowering: a golden output, many ways to write the input, and the inputs that are rejected.

use std::path::Path;

use crate::program::tokens::Tokens;
use crate::program::{DeviceProfile, Features, Parts, ProgramOptions, Unit, link, plan, reflect, validated};
use crate::scene::Scene;

/// Uniforms of every shape: whole, of one element, of two elements that are read at constant indices, walked, and separate.
const INPUT: &str = "\
const ONE: u32 = 1u;
const TWO: u32 = 2u;
struct Law { a: f32, n: vec4f }
struct Frame { zero: u32 }
@group(0) @binding(3) var<uniform> frame: Frame;
@group(0) @binding(50) var<uniform> law: Law;
@group(0) @binding(51) var<uniform> one: array<Law, ONE>;
@group(0) @binding(52) var<uniform> pair: array<Law, TWO>;
@group(0) @binding(53) var<uniform> list: array<Law, TWO>;
@group(0) @binding(0) var<storage, read_write> out: array<f32>;

fn rate(x: f32) -> f32 {
    return law.a * one[u32(pair[0].a)].a + pair[1u].n.x + list[frame.zero].a * x;
}

// The entry point {of the pass}.
@compute @workgroup_size(1)
fn entry() {
    out[0] = rate(1.0);
}
";

fn linked(text: &str) -> String {
    let device = DeviceProfile::cpu(8);
    let parts = Parts { shared: vec![Unit::user("input.wgsl", text.to_owned())], device, ..Parts::default() };
    let linked = link(&parts, "entry").unwrap_or_else(|error| panic!("{error}\n{text}"));
    validated(&linked).unwrap_or_else(|error| panic!("{error}\n{}", linked.source));
    linked.source
}

fn error(text: &str) -> String {
    let device = DeviceProfile::cpu(8);
    let parts = Parts { shared: vec![Unit::user("input.wgsl", text.to_owned())], device, ..Parts::default() };
    link(&parts, "entry").and_then(|linked| reflect(&linked)).map(|_| text).unwrap_err().to_string()
}

fn words(text: &str) -> Vec<String> {
    let tokens = Tokens::of(text);
    (0..tokens.len()).map(|i| tokens.word(i).to_owned()).collect()
}

/// Returns the text with `gap` between its tokens, wherever the language allows it.
fn with_gaps(text: &str, gap: &str) -> String {
    let words = words(text);
    let brackets = ["(", ")", "{", "}", "[", "]", ",", ";", ":", "@"];
    let is_word = |word: &str| word.starts_with(|c: char| c.is_alphanumeric() || c == '_');
    let mut spaced = words.first().map_or_else(String::new, ToString::to_string);
    for pair in words.windows(2) {
        let [a, b] = [&*pair[0], &*pair[1]];
        if is_word(a) && is_word(b) {
            spaced += if gap.is_empty() { " " } else { gap };
        } else if brackets.contains(&a) || brackets.contains(&b) || (b == "<" && is_word(a)) {
            spaced += gap;
        }
        spaced += b;
    }
    spaced
}

const GAPS: [&str; 5] = ["", " ", "\n\n\t", " /* } ; { /* , */ */ ", " // fn x() {\r\n"];

#[test]
fn the_output_is_as_it_was() {
    assert_eq!(linked(INPUT), include_str!("golden.wgsl"));
}

#[test]
fn formatting_changes_nothing() {
    let golden = linked(INPUT);
    for gap in GAPS {
        let spaced = with_gaps(INPUT, gap);
        assert_eq!(words(&linked(&spaced)), words(&golden), "{spaced}");
    }
    for (from, to, ty) in [
        ("const ONE: u32 = 1u;", "const ONE = 1u;", ""),
        ("const ONE: u32 = 1u;", "const ONE: u32 = 1;", ""),
        ("const ONE: u32 = 1u;", "const UNIT = 0x1; const ONE = UNIT;", ""),
        ("array<Law, ONE>", "array<Law,ONE,>", ""),
        ("array<Law, ONE>", "array<Law, 1>", "array<Law, 1>"),
        ("array<Law, ONE>;", "Only; alias Only = array<Law, ONE>;", "Only"),
        ("@group(0) @binding(51)", "@binding(51u,) @group(0)", ""),
        ("pair[0]", "pair[0x0u]", ""),
        ("one[u32(pair[0].a)]", "one [ u32(pair[0].n[1]) ]", ""),
    ] {
        let changed = linked(&INPUT.replace(from, to));
        let expected = if ty.is_empty() { golden.clone() } else { golden.replace("array<Law, ONE>", ty) };
        let from_functions = |text: &str| words(text.split("fn rate").last().unwrap_or_default()).join(" ");
        assert_eq!(from_functions(&changed), from_functions(&expected), "{to}");
        let made = |text: &str| words(text.split("// ---- input").next().unwrap_or_default()).join(" ");
        assert_eq!(made(&changed), made(&expected), "{to}");
    }
}

/// The scenes have every kind of declaration, and copies of regions.
#[test]
fn formatting_changes_no_scene() {
    for name in ["black_hole", "thesis/luneburg", "thesis/gaussian"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("scenes/{name}.toml"));
        let scene = Scene::load(&path, &[]).unwrap();
        let analysis = crate::program::Analysis::of(&scene);
        let features = Features::of(&scene, &ProgramOptions::default(), &analysis);
        let parts = plan(&scene, &analysis, &features).unwrap();
        let spaced = |unit: &Unit, gap: &str| Unit { text: with_gaps(&unit.text, gap).into(), ..unit.clone() };
        for pass in features.passes() {
            let golden = link(&parts, pass.entry()).unwrap().source;
            for gap in GAPS {
                let all = |units: &[Unit]| units.iter().map(|unit| spaced(unit, gap)).collect::<Vec<_>>();
                let parts = Parts {
                    shared: all(&parts.shared),
                    regions: parts.regions.iter().map(|region| all(region)).collect(),
                    ..parts.clone()
                };
                assert_eq!(words(&link(&parts, pass.entry()).unwrap().source), words(&golden), "{name}, {gap:?}");
            }
        }
    }
}

/// Uses that are legal but that no copy can replace are not changed.
#[test]
fn unusual_uses_read_the_uniform_itself() {
    for (from, to, left) in [
        ("one[u32(pair[0].a)].a", "whole(one)", "uniforms_entry.one"),
        ("one[u32(pair[0].a)].a", "one[u32(whole(one))].a", "uniforms_entry.one[u32(whole(uniforms_entry.one))]"),
        ("pair[1u]", "pair[TWO - 1u]", "uniforms_entry.pair[TWO - 1u]"),
        ("law.a *", "(*&law).a *", "(*&uniforms_entry.law).a"),
        ("frame.zero", "(*(&frame)).zero", "(*(&frame)).zero"),
    ] {
        let text = INPUT.replace(from, to) + "fn whole(all: array<Law, ONE>) -> f32 { return all[0].a; }\n";
        let source = linked(&text);
        assert!(source.contains(left), "{left}\n{source}");
    }
}

/// Violations of the rules for uniforms, which do not apply to copies; each is reported at its location.
#[test]
fn slips_are_not_hidden() {
    let place = INPUT[..INPUT.find("return").unwrap()].lines().count();
    for (slip, column) in [
        ("law.a = 1.0;", 5),
        ("law.n.x += 1.0;", 5),
        ("((law).a) = 1.0;", 6),
        ("frame.zero++;", 5),
        ("frame.zero <<= 1u;", 5),
        ("let p = &law; (*p).a = 1.0;", 19),
        ("one[0].a = 1.0;", 5),
        ("pair[1].a = 1.0;", 5),
        ("list[0].a = 1.0;", 5),
        ("let y = one[1].a;", 13),
        ("let y = pair[2].a;", 13),
        ("let y = pair[4000000000u].a;", 13),
        ("let y = law.b;", 17),
        ("let y = pair[0].b;", 21),
        ("let y = law.a + one[0].a + two;", 32),
    ] {
        let error = error(&INPUT.replace("    return law.a", &format!("    {slip}\n    return law.a")));
        assert!(error.starts_with(&format!("input.wgsl:{place}:{column}: ")), "{slip} at {place}:{column}: {error}");
    }
}

#[test]
fn made_names_are_refused() {
    for slip in [
        "let own_frame = x; let y = own_frame;",
        "var pair_1 = x;",
        "let uniforms_entry = x;",
        "for (var read_uniforms = 0; read_uniforms < 1; read_uniforms++) {}",
    ] {
        let error = error(&INPUT.replace("    return law.a", &format!("    {slip}\n    return law.a")));
        assert!(error.contains("is reserved by the renderer"), "{slip}: {error}");
        assert!(error.starts_with("input.wgsl:13:"), "{slip}: {error}");
    }
    let error = error(&INPUT.replace("Law", "Uniforms"));
    assert!(error.starts_with("input.wgsl:3:8: the name `Uniforms` is reserved"), "{error}");
}
