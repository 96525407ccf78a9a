//! The units of a program as tokens, before they become declarations.

use std::borrow::Cow;
use std::collections::HashMap;

use super::parts::part_tokens;
use super::tokens::{Tokens, whole_number};
use super::unit::{Author, Parts, Unit};

/// The units of a program and their tokens.
pub(super) struct Sources<'a> {
    /// The units, in the order to which the origins of tokens refer.
    pub(super) units: Vec<Unit>,
    /// The sources that all regions share.
    pub(super) shared: Vec<Source<'a>>,
    /// The sources of each kind of region.
    pub(super) regions: Vec<Vec<Source<'a>>>,
}

/// The tokens of a unit, and its author.
pub(super) struct Source<'a> {
    author: Author,
    pub(super) tokens: Tokens<'a>,
}

impl Source<'_> {
    /// Tokenizes text that the linker generates, as the unit with this index.
    pub(super) fn made(text: &str, unit: usize) -> Source<'static> {
        Source { author: Author::Generated, tokens: Tokens::made(text, unit) }
    }
}

/// The values of a program's constants, by name: `const NAME: bool = true;` and whole numbers.
#[derive(Clone, Default)]
pub(super) struct Known {
    /// The features; constants in a user's file are not included.
    pub(super) bools: HashMap<String, bool>,
    /// All numbers.
    pub(super) numbers: HashMap<String, u32>,
}

impl<'a> Sources<'a> {
    /// Reads the units of a program; built-in modules are already tokenized.
    pub(super) fn of(parts: &'a Parts) -> Self {
        let mut units = Vec::new();
        let mut read = |unit: &'a Unit| {
            units.push(unit.clone());
            let is_part = unit.author == Author::BuiltIn && matches!(unit.text, Cow::Borrowed(_));
            let built_in = if is_part { part_tokens(&unit.file) } else { None };
            let tokens = built_in.unwrap_or_else(|| Tokens::of(&unit.text));
            Source { author: unit.author, tokens: tokens.of_unit(units.len() - 1) }
        };
        let shared = parts.shared.iter().map(&mut read).collect();
        let regions = parts.regions.iter().map(|region| region.iter().map(&mut read).collect()).collect();
        Self { units, shared, regions }
    }

    /// Adds text that the linker generates.
    pub(super) fn add(&mut self, file: &'static str, text: String) {
        self.shared.push(Source::made(&text, self.units.len()));
        self.units.push(Unit::generated(file, text));
    }

    /// Edits every unit except the user's, given the constants that it can use: the shared ones and, in a region, also the region's.
    pub(super) fn edit(&mut self, edit: impl Fn(Tokens<'a>, &Known) -> Tokens<'a>) {
        let shared = Known::default().with(&self.shared);
        let one = |source: &mut Source<'a>, known: &Known| {
            if source.author != Author::User {
                source.tokens = edit(std::mem::take(&mut source.tokens), known);
            }
        };
        for source in &mut self.shared {
            one(source, &shared);
        }
        for region in &mut self.regions {
            let known = shared.clone().with(region);
            for source in region.iter_mut() {
                one(source, &known);
            }
        }
    }

    /// Edits every unit, including the user's.
    pub(super) fn edit_all(&mut self, edit: impl Fn(Tokens<'a>) -> Tokens<'a>) {
        for source in self.shared.iter_mut().chain(self.regions.iter_mut().flatten()) {
            source.tokens = edit(std::mem::take(&mut source.tokens));
        }
    }

    /// Returns the constants of the shared units.
    pub(super) fn known(&self) -> Known {
        Known::default().with(&self.shared)
    }
}

impl Known {
    fn with(mut self, sources: &[Source]) -> Self {
        for Source { author, tokens } in sources {
            for i in (0..tokens.len()).filter(|&i| tokens.word(i) == "const") {
                if !tokens.are(i, &[(2, ":"), (4, "="), (6, ";")]) {
                    continue;
                }
                let (name, value) = (tokens.word(i + 1), tokens.word(i + 5));
                match value {
                    "true" | "false" if *author == Author::User => {}
                    "true" | "false" => drop(self.bools.insert(name.to_owned(), value == "true")),
                    _ => drop(whole_number(value).map(|number| self.numbers.insert(name.to_owned(), number))),
                }
            }
        }
        self
    }

    /// Returns the whole number that a word is, or names.
    pub(super) fn number(&self, word: &str) -> Option<u32> {
        whole_number(word).or_else(|| self.numbers.get(word).copied())
    }
}

#[cfg(test)]
impl Sources<'_> {
    /// Returns the texts of modules after an edit: first the shared modules, then the modules of regions.
    pub(super) fn edited(parts: &Parts, edit: impl for<'s> Fn(&mut Sources<'s>)) -> Vec<String> {
        let mut sources = Sources::of(parts);
        edit(&mut sources);
        sources.shared.iter().chain(sources.regions.iter().flatten()).map(|source| source.tokens.text()).collect()
    }
}
