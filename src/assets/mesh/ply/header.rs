//! The header of a PLY file, which describes its contents.

use std::path::Path;

use super::super::text::{Diagnostics, Wrong, words};
use crate::assets::Stored;
use crate::document::{SceneError, unmarked};

/// The description of a file's contents.
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// The number of vertices.
    pub vertices: u64,
    /// The length of the header in bytes, including a byte-order mark.
    pub length: usize,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    Little,
    Big,
}

/// A group of elements of one kind.
pub(super) struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
}

pub(super) struct Property {
    pub name: String,
    pub kind: Stored,
    /// The number type of the list's length, if it is a list.
    pub length: Option<Stored>,
}

/// The number types, with both of their names.
const KINDS: [(&str, &str, Stored); 8] = [
    ("char", "int8", Stored::I8),
    ("uchar", "uint8", Stored::U8),
    ("short", "int16", Stored::I16),
    ("ushort", "uint16", Stored::U16),
    ("int", "int32", Stored::I32),
    ("uint", "uint32", Stored::U32),
    ("float", "float32", Stored::F32),
    ("double", "float64", Stored::F64),
];

/// Returns the value that represents 1 in a color: integers have eight bits, whatever their type, unless they are `ushort`.
pub(super) fn white(kind: Stored) -> f64 {
    match kind {
        Stored::F32 | Stored::F64 => 1.0,
        Stored::U16 => f64::from(u16::MAX),
        _ => f64::from(u8::MAX),
    }
}

fn kind_named(word: &str) -> Result<Stored, Wrong<'_>> {
    let known = KINDS.iter().find(|(name, other, _)| *name == word || *other == word);
    known.map(|(.., kind)| *kind).ok_or_else(|| {
        let names = KINDS.map(|(name, ..)| name).join(", ");
        (word, format!("unknown type `{word}`"), format!("supported types: {names}"))
    })
}

impl Element {
    /// Returns the smallest size of an element in bytes; `bytes` returns the size of a number.
    pub fn least(&self, bytes: impl Fn(Stored) -> u64) -> u64 {
        self.properties.iter().map(|property| bytes(property.length.unwrap_or(property.kind))).sum()
    }
}

/// The elements that are drawn: polygons, and triangle strips.
const SURFACES: [&str; 2] = ["face", "tristrips"];
/// The names of the list of their vertices.
pub(super) const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// The largest length of a header in bytes.
const LONGEST: usize = 1 << 20;

/// Reads the header of a file.
pub(super) fn read(bytes: &[u8], path: &Path) -> Result<Header, SceneError> {
    let unmarked = unmarked(bytes, path)?;
    let mark = bytes.len() - unmarked.len();
    let front = &unmarked[..unmarked.len().min(LONGEST)];
    let text = String::from_utf8_lossy(front);
    match parse(front, &text) {
        Ok(header) => Ok(Header { length: mark + header.length, ..header }),
        Err(wrong) => {
            let mut mistakes = Diagnostics::of(&text, path);
            mistakes.add(wrong);
            Err(mistakes.error())
        }
    }
}

/// Returns the line ending of the first line; any byte may follow the last line of the header.
fn line_end(bytes: &[u8]) -> char {
    let is_old_mac = bytes.starts_with(b"ply\r") && bytes.get(4) != Some(&b'\n');
    if is_old_mac { '\r' } else { '\n' }
}

fn parse<'a>(bytes: &[u8], text: &'a str) -> Result<Header, Wrong<'a>> {
    let mut header = Header { encoding: Encoding::Ascii, elements: Vec::new(), vertices: 0, length: 0 };
    let mut encoding = None;
    let mut rest = text;
    let mut is_first = true;
    let line_end = line_end(bytes);
    loop {
        if rest.is_empty() {
            return Err((rest, "the header has no end".to_owned(), "end it with `end_header`".to_owned()));
        }
        let end = rest.find(line_end).map_or(rest.len(), |i| i + 1);
        let (line, after) = rest.split_at(end);
        rest = after;
        // Invalid bytes make the decoded text longer, so lines are counted in both.
        header.length += bytes[header.length..]
            .iter()
            .position(|b| char::from(*b) == line_end)
            .map_or(bytes.len() - header.length, |i| i + 1);
        let words: Vec<&str> = words(line).collect();
        if std::mem::take(&mut is_first) {
            if words != ["ply"] {
                return Err((line.trim_end(), "not a PLY file".to_owned(), "the first line must be `ply`".to_owned()));
            }
            continue;
        }
        match words[..] {
            ["end_header"] => break,
            ["format", word, _] => encoding = Some(encoding_named(word)?),
            ["element", name, count] => header.elements.push(element(name, count)?),
            ["property", ref rest @ ..] => {
                let Some(element) = header.elements.last_mut() else {
                    return Err((words[0], "this property belongs to no element".to_owned(), String::new()));
                };
                element.properties.push(property(words[0], rest)?);
            }
            [] | ["comment" | "obj_info", ..] => {}
            [first, ..] => {
                let help =
                    "valid lines are `format ascii 1.0`, `element NAME COUNT`, `property TYPE NAME` and `comment ..`";
                return Err((first, "not a valid header line".to_owned(), help.to_owned()));
            }
        }
    }
    let none =
        || (&text[..3], "the header specifies no format".to_owned(), "for example `format ascii 1.0`".to_owned());
    header.encoding = encoding.ok_or_else(none)?;
    header.vertices = checked(&header.elements).map_err(|problem| (&text[..3], problem, String::new()))?;
    Ok(header)
}

/// Returns the number of vertices, if the elements suffice for a mesh.
fn checked(elements: &[Element]) -> Result<u64, String> {
    let named = |name: &str| elements.iter().filter(|element| element.name == name).collect::<Vec<_>>();
    let listed = || elements.iter().map(|e| format!("{} `{}`", e.count, e.name)).collect::<Vec<_>>().join(", ");
    let [vertex] = named("vertex")[..] else {
        return Err(format!("a mesh requires exactly one element `vertex`, and the header has {}", listed()));
    };
    let has = |element: &Element, names: &[&str], list: bool| {
        let is_it = |p: &Property| names.contains(&p.name.as_str()) && p.length.is_some() == list;
        element.properties.iter().any(is_it)
    };
    if let Some(name) = ["x", "y", "z"].into_iter().find(|name| !has(vertex, &[name], false)) {
        return Err(format!("vertices have no property `{name}`"));
    }
    let surfaces: Vec<&Element> = SURFACES.into_iter().flat_map(named).collect();
    if surfaces.iter().all(|element| element.count == 0) {
        return Err(format!(
            "the file is a point cloud: the header has {}, and triangles require `face` or `tristrips`",
            listed()
        ));
    }
    for surface in surfaces {
        if named(&surface.name).len() > 1 {
            return Err(format!(
                "a mesh requires exactly one element `{}`, and the header has {}",
                surface.name,
                listed()
            ));
        }
        if !has(surface, &CORNERS, true) {
            let lists: Vec<String> = surface.properties.iter().map(|property| format!("`{}`", property.name)).collect();
            let has = if lists.is_empty() { "no property".to_owned() } else { lists.join(", ") };
            return Err(format!("the element `{}` has {has}, and requires a list `vertex_indices`", surface.name));
        }
    }
    Ok(vertex.count)
}

fn encoding_named(word: &str) -> Result<Encoding, Wrong<'_>> {
    match word {
        "ascii" => Ok(Encoding::Ascii),
        "binary_little_endian" => Ok(Encoding::Little),
        "binary_big_endian" => Ok(Encoding::Big),
        _ => {
            let help = "supported formats: ascii, binary_little_endian, binary_big_endian".to_owned();
            Err((word, format!("unknown format `{word}`"), help))
        }
    }
}

fn element<'a>(name: &str, count: &'a str) -> Result<Element, Wrong<'a>> {
    // Triangles store the indices of their corners in 32 bits.
    match count.parse::<u32>() {
        Ok(count) => Ok(Element { name: name.to_owned(), count: u64::from(count), properties: Vec::new() }),
        _ => {
            Err((count, format!("expected a number of elements, found `{count}`"), "use at most 4294967295".to_owned()))
        }
    }
}

/// Parses `TYPE NAME`, or `list TYPE TYPE NAME`.
fn property<'a>(keyword: &'a str, words: &[&'a str]) -> Result<Property, Wrong<'a>> {
    match *words {
        ["list", length, kind, name] => {
            let length = match kind_named(length)? {
                Stored::F32 | Stored::F64 => {
                    return Err((length, "the length of a list must have an integer type".to_owned(), String::new()));
                }
                whole => Some(whole),
            };
            Ok(Property { name: name.to_owned(), kind: kind_named(kind)?, length })
        }
        [kind, name] => Ok(Property { name: name.to_owned(), kind: kind_named(kind)?, length: None }),
        _ => {
            let help = "write `property TYPE NAME`, or `property list TYPE TYPE NAME`".to_owned();
            Err((keyword, "not a valid property".to_owned(), help))
        }
    }
}
