//! What passes bind: the values of pixels joined in one buffer, and numbers for everything.
//!
//! *Theory.* A part declares what it keeps for each pixel by itself, `var<storage, read_write> pixel_color: array<vec3f>`. Bound each
//! apart, such values would be more than a device has bindings for (WebGPU grants eight buffers and four storage textures). So they
//! become members of one struct, the same in every pass of a program: `pixels[place].color`. What no pass reaches is not in it.
//!
//! *Practice.* A variable without a number gets the next one of its pass; the host finds bindings by what they are for.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::declarations::Declaration;
use super::tokens::{Splice, Tokens};

/// What the names of values of pixels begin with.
const PREFIX: &str = "pixel_";
/// The struct's type.
const STRUCT: &str = "Pixel";
/// The buffer of them.
const BUFFER: &str = "pixels";
/// The first number where a part, such as a kernel of its own, has numbers itself.
const BESIDE_OTHERS: u32 = 500;

/// Is it a value of pixels?
pub(super) fn is_of_pixels(declaration: &Declaration) -> bool {
    declaration.space() == Some("storage") && declaration.name().starts_with(PREFIX)
}

/// The values of a program's pixels.
#[derive(Debug, Default)]
pub(super) struct Pixels {
    members: Vec<Member>,
}

#[derive(Debug)]
struct Member {
    variable: String,
    ty: String,
}

impl Pixels {
    /// Of the variables that some pass of the program reaches.
    pub(super) fn of<'d>(variables: impl Iterator<Item = &'d Declaration<'d>>) -> Self {
        let member = |variable: &Declaration| {
            let array = variable.ty()?;
            let ty = variable.tokens.written(array.start + 2..variable.tokens.closing(array.start + 1)?);
            Some(Member { variable: variable.name().to_owned(), ty })
        };
        let mut members: Vec<_> = variables.filter_map(member).collect();
        // Where the numbers come last they fill up what vectors leave.
        members.sort_by_key(|member| ["u32", "f32"].contains(&member.ty.as_str()));
        Self { members }
    }

    /// Names that no part may use for anything else.
    pub(super) fn made(&self) -> BTreeSet<String> {
        let names: &[&str] = if self.members.is_empty() { &[] } else { &[STRUCT, BUFFER] };
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    /// What to write in a declaration for every value: the member of a pixel.
    pub(super) fn splices(&self, declaration: &Declaration) -> Vec<Splice<'static>> {
        let tokens = &declaration.tokens;
        let splices = declaration.names.iter().filter_map(|&i| {
            let member = self.members.iter().find(|member| member.variable == tokens.word(i))?;
            let behind = tokens.closing(i + 1)? + 1;
            let name = Tokens::written_at(&format!(".{}", &member.variable[PREFIX.len()..]), tokens.origin(i));
            Some([(i..i + 1, tokens.replacement(i, BUFFER)), (behind..behind, name)])
        });
        splices.flatten().collect()
    }

    /// The struct and the buffer; empty if a program keeps nothing.
    pub(super) fn declaration(&self) -> String {
        let mut text = String::new();
        if !self.members.is_empty() {
            let _ = writeln!(text, "struct {STRUCT} {{"); // writing to a String cannot fail
            for Member { variable, ty } in &self.members {
                let _ = writeln!(text, "    {}: {ty},", &variable[PREFIX.len()..]);
            }
            let _ = writeln!(text, "}}\n\nvar<storage, read_write> {BUFFER}: array<{STRUCT}>;");
        }
        text
    }
}

/// The numbers that are left in a pass.
pub(super) struct Numbers(u32);

impl Numbers {
    pub(super) fn beside<'a>(mut reached: impl Iterator<Item = &'a Declaration<'a>>) -> Self {
        let has_number = |declaration: &Declaration| declaration.has_attributes() && declaration.keyword() == "var";
        Self(if reached.any(has_number) { BESIDE_OTHERS } else { 0 })
    }

    /// The declaration, with a number if it is bound and has none.
    pub(super) fn given<'a>(&mut self, mut declaration: Declaration<'a>) -> Declaration<'a> {
        let is_bound =
            declaration.keyword() == "var" && matches!(declaration.space(), None | Some("uniform" | "storage"));
        if !is_bound || declaration.has_attributes() {
            return declaration;
        }
        let attributes = declaration.tokens.replacement(0, &format!("@group(0) @binding({})", self.0));
        declaration.tokens.0[0].gap = " ".into();
        self.0 += 1;
        declaration.spliced(vec![(0..0, attributes)])
    }
}
