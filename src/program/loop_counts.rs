//! Counting the iterations of loops, for devices that stop an invocation after so many.
//!
//! *Theory.* Such a device counts the iterations of all loops together, and a loop of n iterations has n + 1 there: the last finds that it is
//! over.
//!
//! *Practice.* For a device with a loop budget every loop adds one to `work` at the beginning of its body and one behind its
//! end, and a pass begins with a call of `begin_counting`.

use std::borrow::Cow;

use super::signature::Signature;
use super::tokens::Tokens;
use super::unit::{Parts, Unit};

/// What adds one.
const COUNT: &str = " work += 1u;";
/// What a pass begins with: all have the parameter `own`.
const BEGIN: &str = " begin_counting(own.lane);";

/// The parts with the iterations of their loops counted, if they are to be.
pub(super) fn counted(parts: Parts) -> Parts {
    if parts.device.loop_budget.is_none() {
        return parts;
    }
    let all = |units: Vec<Unit>| units.into_iter().map(counted_unit).collect();
    Parts { shared: all(parts.shared), regions: parts.regions.into_iter().map(all).collect(), ..parts }
}

fn counted_unit(unit: Unit) -> Unit {
    let tokens = Tokens::of(&unit.text);
    let begins = (0..tokens.len()).filter_map(|at| body_of_pass(&tokens, at)).map(|place| (place, BEGIN));
    let loops = (0..tokens.len()).filter_map(|at| body_of_loop(&tokens, at)).flatten().map(|place| (place, COUNT));
    let mut places: Vec<(usize, &str)> = begins.chain(loops).collect();
    if places.is_empty() {
        return unit;
    }
    places.sort_unstable();
    let mut text = String::with_capacity(unit.text.len() + COUNT.len() * places.len());
    let mut done = 0;
    for (place, counts) in places {
        text += &unit.text[done..place];
        text += counts;
        done = place;
    }
    text += &unit.text[done..];
    Unit { text: Cow::Owned(text), ..unit }
}

/// Where the body begins of the loop at this token, if there is one, and where the loop ends.
fn body_of_loop(tokens: &Tokens, at: usize) -> Option<[usize; 2]> {
    let body = match tokens.word(at) {
        "for" => tokens.closing(at + 1)? + 1,
        "while" => (at..tokens.len()).find(|&i| tokens.word(i) == "{")?,
        "loop" => at + 1,
        _ => return None,
    };
    Some([body, tokens.closing(body)?].map(|brace| tokens.range(brace).end))
}

/// Where the body begins of the pass whose attribute is at this token, if it is one's.
fn body_of_pass(tokens: &Tokens, at: usize) -> Option<usize> {
    if tokens.before(at) != "@" || tokens.word(at) != "compute" {
        return None;
    }
    let signature = Signature::of(tokens, tokens.behind_attributes(at - 1))?;
    let has_lane = signature.parameters.first().is_some_and(|parameter| tokens.word(parameter.name) == "own");
    has_lane.then(|| tokens.range(signature.body).end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::DeviceProfile;

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
        let device = DeviceProfile::cpu(8);
        let parts = Parts { shared: vec![unit(text)], regions: vec![vec![unit(text)]], device };
        let counted = super::counted(parts);
        assert_eq!([&counted.shared[0].text, &counted.regions[0][0].text], [&expected; 2]);
        let uncounted = Parts { shared: vec![unit(text)], ..Parts::default() };
        assert_eq!(super::counted(uncounted.clone()), uncounted);
    }
}
