//! A pass's uniforms: one buffer for all of the scene's, each read once.
//!
//! *Theory.* Every part declares the uniform it reads, by its own name. A pass that binds each apart soon needs more than a
//! device has to give (twelve are sure), and more than lavapipe bears: looking for branches that depend on uniforms alone,
//! Mesa 22.3 counts in steps of 32 through a table with room for 4 a buffer, and a branch on the fifth buffer or a later one
//! writes past its end, into whatever the heap has there. So the uniforms become members of one block; what a tile or a turn
//! writes stays apart.
//!
//! *Practice.* Inside a loop lavapipe reads a uniform once for every lane, each read with a test of its bounds: some 25
//! instructions for one number, and half the time of a Runge–Kutta step. So a pass copies them into variables of its own before
//! it does anything else, where one read serves all lanes. An array that is only read at places written as numbers is copied place
//! by place, and one of a single place as that. Other arrays stay where they are: a copy of an array is memory, which is read
//! no faster.

use std::fmt::Write as _;

use super::declarations::Declaration;

/// Uniforms that are written for each tile, and for each dispatch.
const APART: [&str; 2] = ["frame", "dispatch"];
/// The block's binding.
const BINDING: u32 = 9;

/// The uniforms of a pass.
#[derive(Debug, Default)]
pub(super) struct Block<'a> {
    entry: &'a str,
    /// In the order of the parts.
    uniforms: Vec<Uniform<'a>>,
}

#[derive(Debug)]
struct Uniform<'a> {
    name: &'a str,
    ty: &'a str,
    shape: Shape<'a>,
}

impl Uniform<'_> {
    fn is_apart(&self) -> bool {
        APART.contains(&self.name)
    }
}

#[derive(Debug, PartialEq)]
enum Shape<'a> {
    Single,
    /// An array of one, of this type.
    One(&'a str),
    /// An array of this type that is read at this many places, from the first on, each written as a number.
    Places(&'a str, usize),
    Array,
}

impl<'a> Block<'a> {
    /// Of the declarations that the entry point reaches.
    pub(super) fn of(entry: &'a str, reached: &(impl Iterator<Item = &'a Declaration<'a>> + Clone)) -> Self {
        let ones: Vec<&str> = reached.clone().filter(|declaration| is_one(declaration)).map(|one| one.name).collect();
        let uniforms = reached.clone().filter_map(uniform).map(|(name, ty)| {
            let array = ty.strip_prefix("array<").and_then(|ty| ty.strip_suffix('>')?.rsplit_once(", "));
            let shape = match array {
                None => Shape::Single,
                Some((element, count)) if ones.contains(&count) => Shape::One(element),
                Some((element, _)) => {
                    places(name, reached.clone()).map_or(Shape::Array, |places| Shape::Places(element, places))
                }
            };
            Uniform { name, ty, shape }
        });
        Self { entry, uniforms: uniforms.collect() }
    }

    /// Does the block stand in for this declaration?
    pub(super) fn replaces(&self, declaration: &Declaration) -> bool {
        declaration.keyword == "var" && self.named(declaration.name).is_some_and(|uniform| !uniform.is_apart())
    }

    fn named(&self, name: &str) -> Option<&Uniform<'a>> {
        self.uniforms.iter().find(|uniform| uniform.name == name)
    }

    /// The declaration's text, with every use of a uniform by what stands for it; the entry point reads them first.
    pub(super) fn rewritten(&self, declaration: &Declaration) -> String {
        let mut text = String::new();
        let mut at = 0;
        for range in declaration.identifiers.iter().filter(|_| declaration.keyword == "fn") {
            let name = &declaration.text[range.clone()];
            // What stands in an index that is left out is left out too.
            if let Some(uniform) = self.named(name).filter(|_| range.start >= at) {
                text.push_str(&declaration.text[at..range.start]);
                text.push_str(&self.stand_in(uniform));
                at = range.end;
                let index = || index_length(&declaration.text[range.end..]);
                match uniform.shape {
                    Shape::One(_) => at += index(),
                    Shape::Places(..) => {
                        let place = written_place(&declaration.text[at..]).unwrap_or_default();
                        // Writing to a String cannot fail.
                        let _ = write!(text, "_{place}");
                        at += index();
                    }
                    Shape::Single | Shape::Array => {}
                }
            }
        }
        text.push_str(&declaration.text[at..]);
        if declaration.name == self.entry && self.held().next().is_some() {
            // Its body opens behind its name: the comment above may have braces of its own.
            let signature = text.find(&format!("fn {}(", self.entry)).unwrap_or(0);
            if let Some(brace) = text[signature..].find('{') {
                text.insert_str(signature + brace + 1, " read_uniforms();");
            }
        }
        text
    }

    /// What a use of a uniform is written as: a copy of those in the block has their own name.
    fn stand_in(&self, uniform: &Uniform) -> String {
        let name = uniform.name;
        match uniform.shape {
            _ if uniform.is_apart() => format!("own_{name}"),
            Shape::Array => format!("{}.{name}", self.name()),
            Shape::Single | Shape::One(_) | Shape::Places(..) => name.to_owned(),
        }
    }

    fn name(&self) -> String {
        format!("uniforms_{}", self.entry)
    }

    /// Those that are copied.
    fn held(&self) -> impl Iterator<Item = &Uniform<'a>> {
        self.uniforms.iter().filter(|uniform| uniform.shape != Shape::Array)
    }

    /// The block's own declaration, the copies' and the function that fills them; empty if there are no uniforms.
    pub(super) fn declaration(&self) -> String {
        let mut text = String::new();
        let members: Vec<_> = self.uniforms.iter().filter(|uniform| !uniform.is_apart()).collect();
        // Writing to a String cannot fail.
        if !members.is_empty() {
            // 32 is a multiple of what any member wants, vectors of f64 included.
            text += "struct Uniforms {\n";
            for Uniform { name, ty, .. } in members {
                let _ = writeln!(text, "    @align(32) {name}: {ty},");
            }
            let _ = writeln!(text, "}}\n\n@group(0) @binding({BINDING}) var<uniform> {}: Uniforms;\n", self.name());
        }
        let (mut copies, mut reads) = (String::new(), String::new());
        for uniform in self.held() {
            let (name, own) = (uniform.name, self.stand_in(uniform));
            let read = if uniform.is_apart() { name.to_owned() } else { format!("{}.{name}", self.name()) };
            let mut copy = |copy: &str, ty: &str, index: &str| {
                let _ = writeln!(copies, "var<private> {copy}: {ty};");
                let _ = writeln!(reads, "    {copy} = {read}{index};");
            };
            match uniform.shape {
                Shape::Single | Shape::Array => copy(&own, uniform.ty, ""),
                Shape::One(element) => copy(&own, element, "[0]"),
                Shape::Places(element, places) => {
                    (0..places).for_each(|i| copy(&format!("{own}_{i}"), element, &format!("[{i}]")));
                }
            }
        }
        if !reads.is_empty() {
            let _ = writeln!(text, "{copies}\nfn read_uniforms() {{\n{reads}}}\n");
        }
        text
    }
}

/// The name and the type of a uniform.
fn uniform<'a>(declaration: &'a Declaration<'a>) -> Option<(&'a str, &'a str)> {
    if declaration.keyword != "var" {
        return None;
    }
    let (_, declared) = declaration.text.split_once("var<uniform>")?;
    let (_, ty) = declared.split_once(':')?;
    Some((declaration.name, ty.trim().trim_end_matches(';')))
}

/// Is it a constant of 1, as the length of an array?
fn is_one(declaration: &Declaration) -> bool {
    declaration.keyword == "const" && declaration.text.trim_end().ends_with("u32 = 1u;")
}

/// How many places of the array are read, if each is written as a number wherever it is read.
fn places<'a>(name: &str, reached: impl Iterator<Item = &'a Declaration<'a>>) -> Option<usize> {
    let mut most = 0;
    for declaration in reached.filter(|declaration| declaration.keyword == "fn") {
        for range in declaration.identifiers.iter().filter(|range| &declaration.text[(*range).clone()] == name) {
            most = most.max(1 + written_place(&declaration.text[range.end..])?);
        }
    }
    Some(most)
}

/// The number in brackets that `text` begins with.
fn written_place(text: &str) -> Option<usize> {
    let (index, _) = text.strip_prefix('[')?.split_once(']')?;
    index.trim_end_matches('u').parse().ok()
}

/// How long the index in brackets is that `text` begins with.
fn index_length(text: &str) -> usize {
    let mut depth = 0_usize;
    for (i, sign) in text.char_indices() {
        match sign {
            '[' => depth += 1,
            ']' if depth == 1 => return i + 1,
            ']' => depth -= 1,
            _ => {}
        }
    }
    0
}
