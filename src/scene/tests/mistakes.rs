//! Tests of each kind of invalid input: the message, line and column.

use super::{RAYS, marked, mistakes_of, parse};
use crate::scene::SceneError;

/// The cases: `=== BASE: MESSAGE` and a text with a marked location. The text is the whole scene, or follows the bounding sphere (`rays`)
/// or the header of an object (`object`); the message is part of the problem and the help.
const CASES: &str = include_str!("mistakes.txt");

#[test]
fn each_mistake_has_its_message_and_place() {
    let mut count = 0;
    for case in CASES.split("=== ").skip(1) {
        let (head, text) = case.split_once('\n').expect("a head");
        let (base, message) = head.split_once(": ").expect("a message");
        let before = match base {
            "none" => String::new(),
            "rays" => RAYS.to_owned(),
            "object" => format!("{RAYS}[materials.red]\n[[objects]]\n"),
            _ => panic!("{base}"),
        };
        let mistake = marked(&format!("{before}{}\n", text.trim_end()));
        let said = format!("{}; {}", mistake.problem, mistake.help);
        assert!(said.contains(message), "{said}\nlacks\n{message}");
        count += 1;
    }
    assert_eq!(count, CASES.matches('«').count());
}

#[test]
fn all_mistakes_are_found_in_one_run_in_the_order_of_the_file() {
    let text = "[lamp]\n[camera]\nposition = [0, 0]\nfov = 0\n[law]\nkind = \"sources\"\n[[law.sources]]\n\
                [[law.sources]]\nposition = [0, 0, 0]\nstrength = 0\n[rays]\nstep = nan\n[materials.a]\nkind = \"x\"\n\
                ambient = 0.5\nambiant = 0.5\n[[objects]]\nshape = \"sphere\"\nmaterial = \"b\"\n[[objects]]\n";
    let mistakes = mistakes_of(parse(text));
    let lines: Vec<usize> = mistakes.iter().map(|m| m.line).collect();
    assert_eq!(lines, [1, 3, 4, 7, 7, 10, 11, 12, 14, 16, 19, 20, 20]);
    let shown = SceneError::Diagnostics(mistakes).to_string();
    assert!(shown.ends_with("13 errors"), "{shown}");
}

#[test]
fn a_mistake_shows_its_line() {
    let text = format!("{RAYS}[materials.red]\n[[objects]]\nshape = \"sphere\"\nmaterial = \"red\"\n  raduis = 3\n");
    assert_eq!(
        SceneError::Diagnostics(mistakes_of(parse(&text))).to_string(),
        "scene.toml:7:3: unknown key `raduis`\n    raduis = 3\n    ^^^^^^\n    help: use `radius`; valid keys: shape, \
         center, radius, translate, rotate, scale, material, interior, orbit, velocity\n\n1 error"
    );
}

#[test]
fn columns_count_characters() {
    let text = format!("{RAYS}[materials]\n'größe' = {{ ambient = «2» }}\n");
    assert_eq!(marked(&text).column, 23);
}
