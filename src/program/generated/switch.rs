//! Functions that call what a kind is named for.

use std::fmt::Write as _;

use crate::program::unit::Unit;

pub(in crate::program) fn unit(file: &'static str, text: String) -> Unit {
    Unit::generated(file, text)
}

/// `signature` as a function that returns `call(kind)` for the kind that `selector` names: `kinds` are (constant, name). A single
/// kind needs no switch.
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
