//! Functions that switch between kinds.

use std::fmt::Write as _;

use crate::program::unit::Unit;

pub(in crate::program) fn unit(file: &'static str, text: String) -> Unit {
    Unit::generated(file, text)
}

/// Returns a function with this `signature` that calls the kind with the value of `selector`; `kinds` are pairs of a constant and a call.
/// A single kind needs no switch.
pub(in crate::program) fn switch(signature: &str, selector: &str, kinds: &[(String, String)]) -> String {
    let mut text = format!("{signature} {{\n");
    let Some(((_, last), rest)) = kinds.split_last() else {
        return text + "    return vec3f(0.0);\n}\n";
    };
    if rest.is_empty() {
        let _ = writeln!(text, "    return {last};\n}}");
        return text;
    }
    let _ = writeln!(text, "    switch {selector} {{");
    for (constant, call) in rest {
        let _ = writeln!(text, "        case {constant}: {{\n            return {call};\n        }}");
    }
    let _ = writeln!(text, "        default: {{\n            return {last};\n        }}\n    }}\n}}");
    text
}
