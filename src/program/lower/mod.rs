//! Lowering: a pass's uniforms in the form that drivers accept and run fastest: one buffer for all of the scene's, each read once.
//!
//! *Theory.* Every part declares the uniform it reads, by its own name. A pass that binds each apart soon needs more than a
//! device has to give (twelve are sure), and more than some drivers can take: looking for branches that depend on uniforms alone,
//! Mesa 22.3 counts in steps of 32 through a table with room for 4 a buffer, and a branch on the fifth buffer or a later one
//! writes past its end, into whatever the heap has there. So the uniforms become members of one block; what a tile or a turn
//! writes stays apart.
//!
//! Inside a loop a processor reads a uniform once for every lane, each read with a test of its bounds: some 25 instructions for one
//! number, and half the time of a Runge–Kutta step. So a pass copies them into variables of its own before it does anything else,
//! where one read serves all lanes; on GPUs they stay where they are. An array that is only read at places written as numbers is copied
//! place by place, and one of a single place as that. Other arrays stay where they are: a copy of an array is memory, which is read no
//! faster.
//!
//! *Practice.* Declarations are read, and uses replaced, as tokens. A uniform that is used in a way that only a uniform's own rules
//! can judge (written to, pointed at, indexed outside of its bounds) is not copied, so that naga sees the slip as it was written.

mod uses;

#[cfg(test)]
mod tests;

use std::collections::{BTreeSet, HashMap};
use std::fmt::Write as _;

use self::uses::{Shape, index_end, shape};
use super::DeviceProfile;
use super::declarations::Declaration;
use super::tokens::{Splice, Tokens};

/// Uniforms that are written for each tile, and for each dispatch.
const APART: [&str; 2] = ["frame", "dispatch"];
/// The block's type.
const BLOCK: &str = "Uniforms";
/// The function that fills the copies.
const READ: &str = "read_uniforms";

/// The uniforms of a pass.
#[derive(Debug, Default)]
pub(super) struct Lowering<'a> {
    entry: &'a str,
    /// In the order of the parts.
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
    /// Of the declarations that the entry point reaches.
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

    /// Does the block stand in for this declaration?
    pub(super) fn replaces(&self, declaration: &Declaration) -> bool {
        declaration.keyword() == "var" && self.named(declaration.name()).is_some_and(|uniform| !uniform.is_apart())
    }

    fn named(&self, name: &str) -> Option<&Uniform<'a>> {
        self.uniforms.iter().find(|uniform| uniform.name == name)
    }

    /// Names that no part may use for anything else.
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

    /// What to write in a function for every use of a uniform; the entry point reads them first.
    pub(super) fn splices(&self, declaration: &Declaration) -> Vec<Splice<'static>> {
        let mut splices: Vec<Splice> = Vec::new();
        let Some(signature) = declaration.signature() else { return splices };
        let tokens = &declaration.tokens;
        let mut done = 0;
        for &i in declaration.names.iter().filter(|&&i| i > signature.body) {
            // What stands in an index that is left out is left out too.
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

    /// What a use of a uniform is written as: a copy of those in the block has their own name.
    fn stand_in(&self, uniform: &Uniform, place: Option<u32>) -> String {
        let name = uniform.name;
        match (&uniform.shape, place) {
            (Shape::InPlace, _) => self.original(uniform),
            (_, Some(place)) => format!("{name}_{place}"),
            (_, None) if uniform.is_apart() => format!("own_{name}"),
            (_, None) => name.to_owned(),
        }
    }

    /// The uniform itself.
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

    /// The block's own declaration, the copies' and the function that fills them; empty if there are no uniforms.
    pub(super) fn declaration(&self) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        if self.members().next().is_some() {
            // 32 is a multiple of what any member wants, vectors of f64 included.
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
