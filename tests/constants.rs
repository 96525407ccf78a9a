//! The constants that the Rust code reads from the shaders exist.

use std::collections::BTreeSet;

use bentray::program::constant;

use crate::support::sources;

/// Calls of `constant` with computed arguments, and all values that these can have.
const COMPUTED: [(&str, &[(&str, &str)]); 7] = [
    (
        "part, &part.rsplit('/').next().unwrap_or(part).to_uppercase()",
        &[
            ("surface/material/accretion", "ACCRETION"),
            ("surface/material/blackbody", "BLACKBODY"),
            ("surface/material/emissive", "EMISSIVE"),
            ("surface/material/phong", "PHONG"),
            ("surface/scatter/mirror", "MIRROR"),
            ("surface/scatter/glossy", "GLOSSY"),
            ("surface/scatter/frosted", "FROSTED"),
            ("surface/scatter/microfacet", "MICROFACET"),
            ("surface/scatter/transmissive", "TRANSMISSIVE"),
        ],
    ),
    (
        "\"surface/pattern\", &material.color.part().to_uppercase()",
        &[("surface/pattern", "CONSTANT"), ("surface/pattern", "CHECKER"), ("surface/pattern", "IMAGE")],
    ),
    (
        "\"absorption/density\", &absorption.kind().to_uppercase()",
        &[
            ("absorption/density", "EVEN"),
            ("absorption/density", "FORMULA"),
            ("absorption/density", "COLOR_FORMULA"),
            ("absorption/density", "MIX"),
            ("absorption/density", "WRAPPED"),
            ("absorption/density", "RAINBOW"),
            ("absorption/density", "RAMP"),
            ("absorption/density", "MARBLE"),
        ],
    ),
    (
        "\"segment/ray\", &status.name().to_uppercase()",
        &[
            ("segment/ray", "HIT"),
            ("segment/ray", "ESCAPED"),
            ("segment/ray", "CAPTURED"),
            ("segment/ray", "ENDED"),
            ("segment/ray", "EXHAUSTED"),
            ("segment/ray", "STALLED"),
            ("segment/ray", "FAILED"),
            ("segment/ray", "CUT"),
            ("segment/ray", "OUTSIDE"),
        ],
    ),
    (
        "\"picture/bundle/grid\", name",
        &[("picture/bundle/grid", "STAR_MARGIN"), ("picture/bundle/grid", "BUNDLE_MARGIN")],
    ),
    ("\"segment/ray\", name", &[("segment/ray", "ALIVE"), ("segment/ray", "UNFINISHED")]),
    ("\"state/active\", name", &[("state/active", "GROUP"), ("state/active", "GROUP_WIDTH")]),
];

/// Returns the arguments of every call of the function `constant`.
fn calls() -> BTreeSet<String> {
    let mut calls = BTreeSet::new();
    for (_, text) in sources() {
        for (at, name) in text.match_indices("constant(") {
            let before = text[..at].chars().next_back();
            let is_other = before.is_some_and(|c| c.is_alphanumeric() || matches!(c, '_' | '.' | '"' | '`'));
            if is_other || text[..at].ends_with("fn ") {
                continue;
            }
            let inside = &text[at + name.len()..];
            let mut depth = 1;
            let end = inside.find(|c| {
                depth += i32::from(c == '(') - i32::from(c == ')');
                depth == 0
            });
            calls.insert(inside[..end.unwrap()].split_whitespace().collect::<Vec<_>>().join(" "));
        }
    }
    calls
}

#[test]
fn shared_constants_are_in_the_shaders() {
    let mut computed = BTreeSet::new();
    let mut asked = 0;
    for call in calls() {
        match call.split('"').collect::<Vec<_>>()[..] {
            ["", part, ", ", name, ""] => assert!(constant(part, name).is_finite(), "{call}"),
            _ => drop(computed.insert(call)),
        }
        asked += 1;
    }
    assert!(asked > 15, "the search does not find calls in their present form");
    let known: BTreeSet<String> = COMPUTED.iter().map(|(call, _)| (*call).to_owned()).collect();
    assert_eq!(computed, known, "add the values of computed constants to COMPUTED");
    for (part, name) in COMPUTED.iter().flat_map(|(_, pairs)| *pairs) {
        assert!(constant(part, name).is_finite());
    }
}
