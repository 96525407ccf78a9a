//! Bindings of passes: the per-pixel values joined in one buffer, and binding numbers for all resources.
//!
//! *Theory.* Each module declares its per-pixel values separately, `var<storage, read_write> pixel_color: array<vec3f>`. Separate bindings
//! for them would exceed the limits of a device (WebGPU grants eight buffers and four storage textures). The linker therefore makes them
//! members of one struct, which is equal in all passes of a program: `pixels[place].color`. Values that no pass reaches are left out.
//!
//! *Practice.* A variable without a binding number gets the next free number of its pass; the host finds bindings by their roles.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::declarations::Declaration;
use super::tokens::{Splice, Tokens};

/// The prefix of the names of per-pixel values.
const PREFIX: &str = "pixel_";
/// The type of the struct.
const STRUCT: &str = "Pixel";
/// The buffer of these structs.
const BUFFER: &str = "pixels";
/// The first number that is assigned if a module, such as a custom kernel, contains binding numbers itself.
const BESIDE_OTHERS: u32 = 500;

/// Returns `true` if the declaration is a per-pixel value.
pub(super) fn is_of_pixels(declaration: &Declaration) -> bool {
    declaration.space() == Some("storage") && declaration.name().starts_with(PREFIX)
}

/// The per-pixel values of a program.
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
    /// Collects the per-pixel values among the variables that some pass of the program reaches.
    pub(super) fn of<'d>(variables: impl Iterator<Item = &'d Declaration<'d>>) -> Self {
        let member = |variable: &Declaration| {
            let array = variable.ty()?;
            let ty = variable.tokens.written(array.start + 2..variable.tokens.closing(array.start + 1)?);
            Some(Member { variable: variable.name().to_owned(), ty })
        };
        let mut members: Vec<_> = variables.filter_map(member).collect();
        // Scalars come last, to fill the padding after vectors.
        members.sort_by_key(|member| ["u32", "f32"].contains(&member.ty.as_str()));
        Self { members }
    }

    /// Returns the names that the linker reserves for itself.
    pub(super) fn made(&self) -> BTreeSet<String> {
        let names: &[&str] = if self.members.is_empty() { &[] } else { &[STRUCT, BUFFER] };
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    /// Returns the replacements for a declaration's uses of these values: members of the struct of a pixel.
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

    /// Returns the declarations of the struct and the buffer; empty if the program keeps no per-pixel values.
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

/// The binding numbers that are still free in a pass.
pub(super) struct Numbers(u32);

impl Numbers {
    pub(super) fn beside<'a>(mut reached: impl Iterator<Item = &'a Declaration<'a>>) -> Self {
        let has_number = |declaration: &Declaration| declaration.has_attributes() && declaration.keyword() == "var";
        Self(if reached.any(has_number) { BESIDE_OTHERS } else { 0 })
    }

    /// Returns the declaration, with a binding number if it is a binding without one.
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
