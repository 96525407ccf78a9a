//! Options with several values: `from=[0,0,5] toward=[0,0,0] count=9`, separated by spaces or commas.

use glam::DVec3;

/// The pairs of one option, with an example of its syntax.
pub(super) struct Pairs<'t> {
    pairs: Vec<(&'t str, &'t str)>,
    example: &'static str,
}

impl<'t> Pairs<'t> {
    /// Reads pairs whose keys are all `known`; otherwise the error shows `example`.
    pub fn read(text: &'t str, known: &[&str], example: &'static str) -> Result<Self, String> {
        let mut pairs: Vec<(&str, &str)> = Vec::new();
        let mut rest = text.trim_matches(is_gap);
        while !rest.is_empty() {
            let Some((key, value)) = rest.split_once('=') else {
                return Err(format!("expected KEY=VALUE, as in `{example}`, found `{rest}`"));
            };
            let key = key.trim();
            if !known.contains(&key) {
                return Err(format!(
                    "unknown key `{key}`, expected one of {}; for example `{example}`",
                    known.join(", ")
                ));
            }
            if pairs.iter().any(|(other, _)| *other == key) {
                return Err(format!("`{key}` is given twice; keep one"));
            }
            let value = value.trim_start();
            let end = if value.starts_with('[') {
                value.find(']').map(|end| end + 1).ok_or_else(|| format!("missing `]` in `{key}={value}`"))?
            } else {
                value.find(is_gap).unwrap_or(value.len())
            };
            pairs.push((key, &value[..end]));
            rest = value[end..].trim_matches(is_gap);
        }
        Ok(Self { pairs, example })
    }

    /// Returns the text of a value, if it is given.
    pub fn get(&self, key: &str) -> Option<&'t str> {
        self.pairs.iter().find(|(known, _)| *known == key).map(|(_, value)| *value)
    }

    fn required(&self, key: &str) -> Result<&'t str, String> {
        self.get(key).ok_or_else(|| format!("missing `{key}`; for example `{}`", self.example))
    }

    /// Returns a position or a direction.
    pub fn vector(&self, key: &str) -> Result<DVec3, String> {
        vector(self.required(key)?).map_err(|problem| format!("`{key}`: {problem}"))
    }

    /// Returns a number in (0, most].
    pub fn positive(&self, key: &str, most: f64) -> Result<f64, String> {
        let text = self.required(key)?;
        let number = text.parse().ok().filter(|number| *number > 0.0 && *number <= most);
        number.ok_or_else(|| format!("`{key}`: expected a number > 0 and at most {most}, found `{text}`"))
    }

    /// Returns a whole number from 1 to `most`.
    pub fn count(&self, key: &str, most: usize) -> Result<usize, String> {
        let text = self.required(key)?;
        let number = text.parse().ok().filter(|number| (1..=most).contains(number));
        number.ok_or_else(|| format!("`{key}`: expected a whole number from 1 to {most}, found `{text}`"))
    }
}

/// Parses a vector such as `[1, 2, 3]`.
pub(super) fn vector(text: &str) -> Result<DVec3, String> {
    numbers(text)
        .map(DVec3::from_array)
        .ok_or_else(|| format!("expected three numbers such as [1, 0, -2.5], found `{text}`"))
}

/// Parses `N` finite numbers in brackets.
pub(super) fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let inner = text.trim().strip_prefix('[')?.strip_suffix(']')?;
    let words = inner.split(is_gap).filter(|word| !word.is_empty());
    let numbers: Option<Vec<f64>> = words.map(|word| word.parse().ok().filter(|n: &f64| n.abs() <= 1e30)).collect();
    numbers?.try_into().ok()
}

fn is_gap(c: char) -> bool {
    c == ',' || c.is_whitespace()
}
