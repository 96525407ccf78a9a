//! The turn in which a loop ends, counted as those before it.
//!
//! *Theory.* Lavapipe stops an invocation after so many turns of all its loops together, and a loop of n turns has n + 1 there: the last
//! finds that it is over. Short loops one in the other come to twice what their bodies count.
//!
//! *Practice.* Behind every loop whose body begins with `work += 1u;` stands the same once more, in its closing line.

use std::borrow::Cow;

use super::tokens::Tokens;
use super::unit::{Author, Parts, Unit};

const COUNT: [&str; 5] = ["work", "+", "=", "1u", ";"];

/// The parts with the ends of their loops counted.
pub(super) fn counted(parts: Parts) -> Parts {
    let all = |units: Vec<Unit>| units.into_iter().map(counted_unit).collect();
    Parts { shared: all(parts.shared), regions: parts.regions.into_iter().map(all).collect() }
}

fn counted_unit(unit: Unit) -> Unit {
    if unit.author == Author::User || !unit.text.contains("work") {
        return unit;
    }
    let tokens = Tokens::of(&unit.text);
    let mut ends: Vec<usize> = (0..tokens.len()).filter_map(|at| end_of_loop(&tokens, at)).collect();
    ends.sort_unstable();
    let mut text = String::with_capacity(unit.text.len() + 14 * ends.len());
    let mut done = 0;
    for end in ends {
        text += &unit.text[done..end];
        text += " work += 1u;";
        done = end;
    }
    text += &unit.text[done..];
    Unit { text: Cow::Owned(text), ..unit }
}

/// Where the loop ends that begins with this token, if one does that counts.
fn end_of_loop(tokens: &Tokens, at: usize) -> Option<usize> {
    let head = match tokens.word(at) {
        "for" => tokens.closing(at + 1)? + 1,
        "while" => (at..tokens.len()).find(|&i| tokens.word(i) == "{")?,
        "loop" => at + 1,
        _ => return None,
    };
    let counts = (0..COUNT.len()).all(|k| tokens.word(head + 1 + k) == COUNT[k]);
    Some(tokens.range(tokens.closing(head)?).end).filter(|_| counts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_loop_that_counts_counts_its_end() {
        let text = "fn f() {\n    for (var i = 0u; i < n(2u); i++) {\n        work += 1u;\n        while i < 3u {\n            work += 1u; // a turn\n        }\n    }\n    loop { work += 1u; break; }\n    loop { break; }\n}\n";
        let unit = Unit::generated("a.wgsl", text.to_owned());
        let expected = text.replacen("        }\n", "        } work += 1u;\n", 1).replacen(
            "\n    }\n",
            "\n    } work += 1u;\n",
            1,
        );
        let expected = expected.replace("work += 1u; break; }", "work += 1u; break; } work += 1u;");
        assert_eq!(counted_unit(unit).text, expected);
    }
}
