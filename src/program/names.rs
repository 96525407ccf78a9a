//! The modules chosen so far, by name.

use super::unit::{Author, Unit};
use super::user_wgsl::checked;
use super::{ProgramError, part};
use crate::model::Wgsl;

/// Names of modules, and generated text.
#[derive(Default)]
pub(super) struct Names {
    names: Vec<String>,
    made: Vec<Unit>,
}

impl Names {
    /// Adds a module, unless it is already there.
    pub fn add(&mut self, name: &str) {
        if !self.names.iter().any(|known| known == name) {
            self.names.push(name.to_owned());
        }
    }

    pub fn all(&mut self, names: &[&str]) {
        for name in names {
            self.add(name);
        }
    }

    /// Adds modules if they are needed.
    pub fn when(&mut self, needed: bool, names: &[&str]) {
        if needed {
            self.all(names);
        }
    }

    pub fn each<'a>(&mut self, folder: &str, files: impl IntoIterator<Item = &'a str>) {
        files.into_iter().for_each(|file| self.add(&format!("{folder}/{file}")));
    }

    /// Adds the WGSL of a kind.
    pub fn wgsl(&mut self, parts: impl IntoIterator<Item = Wgsl>) -> Result<(), ProgramError> {
        for part in parts {
            match part {
                Wgsl::Part(name) => self.add(&name),
                Wgsl::Text { file, text } => self.made.push(Unit { file, text, author: Author::Generated }),
                Wgsl::Own(own) => {
                    let (unit, usual) = checked(&own)?;
                    self.all(&usual);
                    self.made.push(unit);
                }
            }
        }
        Ok(())
    }

    /// Adds generated text.
    pub fn make(&mut self, unit: Unit) {
        self.made.push(unit);
    }

    /// Returns the modules, followed by the generated text.
    pub fn units(self) -> Result<Vec<Unit>, ProgramError> {
        let found = |name: &String| part(name).map(Unit::from).ok_or_else(|| ProgramError::NoPart(name.clone()));
        let mut units: Vec<Unit> = self.names.iter().map(found).collect::<Result<_, _>>()?;
        units.extend(self.made);
        Ok(units)
    }
}
