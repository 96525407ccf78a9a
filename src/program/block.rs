//! One uniform buffer for all of a scene's uniforms that a pass reaches.
//!
//! *Theory.* Every part declares the uniform it reads, by its own name. A pass that binds each apart soon needs more than a
//! device has to give (twelve are sure), and more than lavapipe bears: looking for branches that depend on uniforms alone,
//! Mesa 22.3 counts in steps of 32 through a table with room for 4 a buffer, and a branch on the fifth buffer or a later one
//! writes past its end, into whatever the heap has there. So the uniforms become members of one block, and `law.mass` is read
//! as `uniforms_advance.law.mass`. What a tile or a turn writes stays apart.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::declarations::Declaration;

/// Uniforms that are written for each tile, and for each dispatch.
const APART: [&str; 2] = ["frame", "turn"];
/// The block's binding.
const BINDING: u32 = 9;

/// The uniforms of a pass that go into its block.
#[derive(Debug, Default)]
pub(super) struct Block<'a> {
    name: String,
    /// Name and type.
    members: Vec<(&'a str, &'a str)>,
    names: BTreeSet<&'a str>,
}

impl<'a> Block<'a> {
    /// Of the declarations that the entry point reaches.
    pub(super) fn of(entry: &str, reached: impl Iterator<Item = &'a Declaration<'a>>) -> Self {
        let members: Vec<_> = reached.filter_map(member).collect();
        let names = members.iter().map(|(name, _)| *name).collect();
        Self { name: format!("uniforms_{entry}"), members, names }
    }

    /// Does the block stand in for this declaration?
    pub(super) fn replaces(&self, declaration: &Declaration) -> bool {
        declaration.keyword == "var" && self.names.contains(declaration.name)
    }

    /// The declaration's text, with every use of a member through the block.
    pub(super) fn rewritten(&self, declaration: &Declaration) -> String {
        let mut text = String::new();
        let mut at = 0;
        for range in &declaration.identifiers {
            if self.names.contains(&declaration.text[range.clone()]) {
                text.push_str(&declaration.text[at..range.start]);
                let _ = write!(text, "{}.", self.name); // writing to a String cannot fail
                at = range.start;
            }
        }
        text.push_str(&declaration.text[at..]);
        text
    }

    /// The block's own declaration; empty if nothing goes into it.
    pub(super) fn declaration(&self) -> String {
        if self.members.is_empty() {
            return String::new();
        }
        // 32 is a multiple of what any member wants, vectors of f64 included.
        let mut text = String::from("struct Uniforms {\n");
        for (name, ty) in &self.members {
            let _ = writeln!(text, "    @align(32) {name}: {ty},");
        }
        let _ = writeln!(text, "}}\n\n@group(0) @binding({BINDING}) var<uniform> {}: Uniforms;", self.name);
        text
    }
}

fn member<'a>(declaration: &'a Declaration<'a>) -> Option<(&'a str, &'a str)> {
    if declaration.keyword != "var" || APART.contains(&declaration.name) {
        return None;
    }
    let (_, declared) = declaration.text.split_once("var<uniform>")?;
    let (_, ty) = declared.split_once(':')?;
    Some((declaration.name, ty.trim().trim_end_matches(';')))
}
