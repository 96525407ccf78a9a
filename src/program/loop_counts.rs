//! Counting of loop iterations, for devices that stop an invocation after a limit.
//!
//! *Theory.* Such a device counts the iterations of all loops together, and it
//! counts n + 1 for a loop of n iterations, because the last test ends the loop.
//!
//! *Practice.* For a device with a loop budget, every loop adds one to `work` at the beginning of its body and one after its
//! end, and a pass begins with a call of `begin_counting`.

use super::signature::Signature;
use super::tokens::{Splice, Tokens};

/// The statement that counts one iteration.
const COUNT: &str = " work += 1u;";
/// The first statement of a pass; all passes have the parameter `own`.
const BEGIN: &str = " begin_counting(own.lane);";

/// Returns the tokens of a unit, in which loops count their iterations.
pub(super) fn counted(tokens: Tokens) -> Tokens {
    let begins = (0..tokens.len()).filter_map(|at| body_of_pass(&tokens, at)).map(|brace| (brace, BEGIN));
    let loops = (0..tokens.len()).filter_map(|at| body_of_loop(&tokens, at)).flatten().map(|brace| (brace, COUNT));
    let behind = |(brace, text): (usize, &str)| -> Splice {
        (brace + 1..brace + 1, Tokens::written_at(text, tokens.origin(brace)))
    };
    let splices = begins.chain(loops).map(behind).collect();
    tokens.spliced(splices)
}

/// Returns the braces that open and close the body of the loop at this token, if there is one.
fn body_of_loop(tokens: &Tokens, at: usize) -> Option<[usize; 2]> {
    let body = match tokens.word(at) {
        "for" => tokens.closing(at + 1)? + 1,
        "while" => (at..tokens.len()).find(|&i| tokens.word(i) == "{")?,
        "loop" => at + 1,
        _ => return None,
    };
    Some([body, tokens.closing(body)?])
}

/// Returns the brace that opens the body of the pass with the attribute at this token, if there is one.
fn body_of_pass(tokens: &Tokens, at: usize) -> Option<usize> {
    if tokens.before(at) != "@" || tokens.word(at) != "compute" {
        return None;
    }
    let signature = Signature::of(tokens, tokens.behind_attributes(at - 1))?;
    let has_lane = signature.parameters.first().is_some_and(|parameter| tokens.word(parameter.name) == "own");
    has_lane.then_some(signature.body)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::sources::Sources;
    use crate::program::{Parts, Unit};

    #[test]
    fn every_iteration_and_every_end_of_a_loop_counts() {
        let text = "@compute @workgroup_size(1) fn pass(own: Invocation) {}\nfn f() {\n    for (var i = 0u; i < n(2u); i++) {\n        while i < 3u {\n            g();\n        }\n    }\n    \
                    loop { break; }\n}\n";
        let unit = |text: &str| Unit::generated("a.wgsl", text.to_owned());
        let expected = text
            .replace("{}", "{ begin_counting(own.lane);}")
            .replace("++) {", "++) { work += 1u;")
            .replace("3u {", "3u { work += 1u;");
        let expected = expected.replace("        }\n    }\n", "        } work += 1u;\n    } work += 1u;\n");
        let expected = expected.replace("loop { break; }", "loop { work += 1u; break; } work += 1u;");
        let parts = Parts { shared: vec![unit(text)], regions: vec![vec![unit(text)]], ..Parts::default() };
        let counted = Sources::edited(&parts, |sources| sources.edit_all(counted));
        assert_eq!(counted, [expected.trim_end(); 2]);
    }
}
