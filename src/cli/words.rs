//! The words of the command line as typed, for commands that repeat them.

use std::env;

/// Returns the words after the first `skip`, without these options: some have a value after them or after `=`, and some have none.
pub(super) fn typed(skip: usize, with_value: &[&str], alone: &[&str]) -> Vec<String> {
    without(env::args().skip(skip), with_value, alone)
}

fn without(words: impl Iterator<Item = String>, with_value: &[&str], alone: &[&str]) -> Vec<String> {
    let mut kept = Vec::new();
    let mut skips = false;
    for word in words {
        if std::mem::take(&mut skips) {
            continue;
        }
        let name = word.split('=').next().unwrap_or_default();
        if with_value.contains(&name) {
            skips = name == word;
        } else if !alone.contains(&word.as_str()) {
            kept.push(word);
        }
    }
    kept
}

/// Quotes the words for a shell.
pub(super) fn quoted(words: &[String]) -> String {
    // Only NUL cannot be quoted, and arguments contain none.
    shlex::try_join(words.iter().map(String::as_str)).unwrap_or_else(|_| words.join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_left_out_and_words_quoted() {
        let typed =
            ["a b.toml", "--continue", "x.exr", "--preview=y.png", "--every", "3", "--now", "-o", "{frame}.exr"];
        let kept = without(typed.map(str::to_owned).into_iter(), &["--continue", "--preview", "--every"], &["--now"]);
        assert_eq!(quoted(&kept), "'a b.toml' -o '{frame}.exr'");
    }
}
