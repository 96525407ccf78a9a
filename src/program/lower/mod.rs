//! Lowering of a pass's uniforms to a form that drivers accept and run fast: one buffer for all of the scene's uniforms, each read once.
//!
//! *Theory.* Every module declares the uniform that it reads under a separate name. Separate bindings soon exceed the limit of a
//! device (twelve are guaranteed) and the ability of some drivers: to find branches that depend on uniforms alone, Mesa 22.3 indexes
//! in steps of 32 a table with room for 4 entries per buffer, and a branch on the fifth or a later buffer writes past its end, into
//! the heap. The uniforms therefore become members of one block; uniforms that a tile or a dispatch writes remain separate.
//!
//! Inside a loop a CPU reads a uniform once for every lane, with a bounds check for each read: some 25 instructions for one number,
//! and half the time of a Runge–Kutta step. On CPUs a pass therefore first copies the uniforms into private variables, with one read
//! for all lanes; on GPUs they are not copied. An array that is only read at constant indices is copied element by element, and an
//! array of a single element as one value. Other arrays are not copied: a copy of an array is in memory, which is not faster to read.
//!
//! *Practice.* Declarations are read, and uses replaced, as tokens. A uniform is not copied if one of its uses is checked by the rules for
//! uniforms (a write, an address, an index out of bounds), so that naga reports the error as it was written.

mod uses;

#[cfg(test)]
mod tests;

use std::collections::{BTreeSet, HashMap};
use std::fmt::Write as _;

use self::uses::{Shape, index_end, shape};
use super::DeviceProfile;
use super::declarations::Declaration;
use super::tokens::{Splice, Tokens};

/// The uniforms that are written for each tile, and for each dispatch.
const APART: [&str; 2] = ["frame", "dispatch"];
/// The type of the block.
const BLOCK: &str = "Uniforms";
/// The function that fills the copies.
const READ: &str = "read_uniforms";

/// The uniforms of a pass.
#[derive(Debug, Default)]
pub(super) struct Lowering<'a> {
    entry: &'a str,
    /// The uniforms in the order of the modules.
    uniforms: Vec<Uniform<'a>>,
}

#[derive(Debug)]
struct Uniform<'a> {
    name: &'a str,
    ty: String,
    shape: Shape,
}

impl Uniform<'_> {
    fn is_apart(&self) -> bool {
        APART.contains(&self.name)
    }
}

impl<'a> Lowering<'a> {
    /// Collects the uniforms among the declarations that the entry point reaches.
    pub(super) fn of(entry: &'a str, reached: &[&'a Declaration<'a>], device: &DeviceProfile) -> Self {
        let by_name: HashMap<&str, &Declaration> = reached.iter().map(|own| (own.name(), *own)).collect();
        let uniforms = reached.iter().filter(|declaration| declaration.is_uniform()).filter_map(|declaration| {
            let ty = declaration.ty()?;
            let copied = device.is_processor.then(|| shape(declaration, reached, &by_name));
            Some(Uniform {
                name: declaration.name(),
                ty: declaration.tokens.written(ty),
                shape: copied.unwrap_or(Shape::InPlace),
            })
        });
        Self { entry, uniforms: uniforms.collect() }
    }

    /// Returns `true` if the block replaces this declaration.
    pub(super) fn replaces(&self, declaration: &Declaration) -> bool {
        declaration.keyword() == "var" && self.named(declaration.name()).is_some_and(|uniform| !uniform.is_apart())
    }

    fn named(&self, name: &str) -> Option<&Uniform<'a>> {
        self.uniforms.iter().find(|uniform| uniform.name == name)
    }

    /// Returns the names that the linker reserves for itself.
    pub(super) fn made(&self) -> BTreeSet<String> {
        let mut made = BTreeSet::new();
        if self.members().next().is_some() {
            made.extend([BLOCK.to_owned(), self.block()]);
        }
        if self.copied().next().is_some() {
            made.insert(READ.to_owned());
        }
        for uniform in self.copied() {
            match uniform.shape {
                Shape::Places(_, places) => made.extend((0..places).map(|i| self.stand_in(uniform, Some(i)))),
                _ if uniform.is_apart() => drop(made.insert(self.stand_in(uniform, None))),
                _ => {}
            }
        }
        made
    }

    /// Returns the replacements for every use of a uniform in a function; the entry point copies the uniforms first.
    pub(super) fn splices(&self, declaration: &Declaration) -> Vec<Splice<'static>> {
        let mut splices: Vec<Splice> = Vec::new();
        let Some(signature) = declaration.signature() else { return splices };
        let tokens = &declaration.tokens;
        let mut done = 0;
        for &i in declaration.names.iter().filter(|&&i| i > signature.body) {
            // A use inside a dropped index is dropped too.
            let Some(uniform) = self.named(tokens.word(i)).filter(|_| i >= done) else { continue };
            let (end, place) = match uniform.shape {
                Shape::One(_) => (index_end(tokens, i), None),
                Shape::Places(..) => (index_end(tokens, i), uses::written_place(tokens, i)),
                Shape::Whole | Shape::InPlace => (i, None),
            };
            done = end + 1;
            splices.push((i..done, tokens.replacement(i, &self.stand_in(uniform, place))));
        }
        if declaration.name() == self.entry && self.copied().next().is_some() {
            let behind = signature.body + 1;
            let read = Tokens::written_at(&format!(" {READ}();"), tokens.origin(signature.body));
            splices.push((behind..behind, read));
        }
        splices
    }

    /// Returns the replacement for a use of a uniform; copies of members of the block have the member's name.
    fn stand_in(&self, uniform: &Uniform, place: Option<u32>) -> String {
        let name = uniform.name;
        match (&uniform.shape, place) {
            (Shape::InPlace, _) => self.original(uniform),
            (_, Some(place)) => format!("{name}_{place}"),
            (_, None) if uniform.is_apart() => format!("own_{name}"),
            (_, None) => name.to_owned(),
        }
    }

    /// Returns the expression of the uniform itself.
    fn original(&self, uniform: &Uniform) -> String {
        if uniform.is_apart() { uniform.name.to_owned() } else { format!("{}.{}", self.block(), uniform.name) }
    }

    fn block(&self) -> String {
        format!("uniforms_{}", self.entry)
    }

    fn members(&self) -> impl Iterator<Item = &Uniform<'a>> {
        self.uniforms.iter().filter(|uniform| !uniform.is_apart())
    }

    fn copied(&self) -> impl Iterator<Item = &Uniform<'a>> {
        self.uniforms.iter().filter(|uniform| uniform.shape != Shape::InPlace)
    }

    /// Returns the declarations of the block, of the copies and of the function that fills them; empty if there are no uniforms.
    pub(super) fn declaration(&self) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        if self.members().next().is_some() {
            // 32 is a multiple of the alignment of all members, including vectors of f64.
            let _ = writeln!(text, "struct {BLOCK} {{");
            for Uniform { name, ty, .. } in self.members() {
                let _ = writeln!(text, "    @align(32) {name}: {ty},");
            }
            let _ = writeln!(text, "}}\n\nvar<uniform> {}: {BLOCK};\n", self.block());
        }
        let (mut copies, mut reads) = (String::new(), String::new());
        for uniform in self.copied() {
            let original = self.original(uniform);
            let mut copy = |place: Option<u32>, ty: &str, index: &str| {
                let own = self.stand_in(uniform, place);
                let _ = writeln!(copies, "var<private> {own}: {ty};");
                let _ = writeln!(reads, "    {own} = {original}{index};");
            };
            match &uniform.shape {
                Shape::InPlace => {}
                Shape::Whole => copy(None, &uniform.ty, ""),
                Shape::One(element) => copy(None, element, "[0]"),
                Shape::Places(element, places) => (0..*places).for_each(|i| copy(Some(i), element, &format!("[{i}]"))),
            }
        }
        if !reads.is_empty() {
            let _ = writeln!(text, "{copies}\nfn {READ}() {{\n{reads}}}\n");
        }
        text
    }
}
