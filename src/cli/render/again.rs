//! The line that repeats a render.

use std::env;

use super::Arguments;
use crate::cli::share::Target;

/// Options that only say how a picture came about in steps.
const STEPS: [&str; 3] = ["--continue", "--preview", "--preview-every"];

impl Arguments {
    /// What to type for the same files: what was typed, without what only led to them in steps. Where the method was not named it is that
    /// of the first file.
    pub(super) fn again(&self, is_found: bool, first: Target) -> String {
        let typed = without_steps(env::args().skip(1));
        let file = self.paths(first).into_iter().next().filter(|_| is_found);
        let method = file.into_iter().flat_map(|path| ["--method-of".to_owned(), path.display().to_string()]);
        let words: Vec<String> = ["bentray".to_owned()].into_iter().chain(typed).chain(method).collect();
        quoted(&words)
    }
}

/// As a shell takes them.
pub(super) fn quoted(words: &[String]) -> String {
    // Arguments have no NUL, which is all that cannot be quoted.
    shlex::try_join(words.iter().map(String::as_str)).unwrap_or_else(|_| words.join(" "))
}

fn without_steps(words: impl Iterator<Item = String>) -> Vec<String> {
    let mut kept = Vec::new();
    let mut skips = false;
    for word in words {
        if std::mem::take(&mut skips) {
            continue;
        }
        let name = word.split('=').next().unwrap_or_default();
        if STEPS.contains(&name) {
            skips = name == word;
        } else {
            kept.push(word);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_left_out_and_words_quoted() {
        let typed =
            ["render", "a b.toml", "--continue", "x.exr", "--preview=y.png", "--preview-every", "3", "-o", "z.exr"];
        let kept = without_steps(typed.map(str::to_owned).into_iter());
        assert_eq!(quoted(&kept), "render 'a b.toml' -o z.exr");
    }
}
