//! The container of a glTF file: JSON, alone or with a buffer in one file, and the buffers that it names.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use gltf_json::{Buffer, Index, Root, buffer::View};

use super::Gltf;
use super::nodes::Maps;
use crate::assets::format_error::{FormatError, are_padding};
use crate::document::{Diagnostic, SceneError, unmarked};

/// The extensions that a file may require, because they are supported or do not affect meshes.
const KNOWN: [&str; 7] = [
    "KHR_mesh_quantization",
    "KHR_lights_punctual",
    "KHR_materials_",
    "KHR_texture_",
    "EXT_texture_",
    "KHR_animation_",
    "KHR_xmp",
];

impl Gltf {
    /// Opens a file from its bytes.
    ///
    /// # Errors
    ///
    /// Returns an error if the bytes are not a glTF 2.0 file, or the file requires an unsupported extension. Buffers are read and checked
    /// later.
    pub fn open(bytes: Vec<u8>, path: &Path) -> Result<Self, SceneError> {
        let is_binary = bytes.starts_with(b"glTF");
        let (json, own) = if is_binary {
            chunks(&bytes).map_err(|flaw| flaw.of(path))?
        } else {
            let text = unmarked(&bytes, path)?;
            (bytes.len() - text.len()..bytes.len(), None)
        };
        let start = json.start;
        let unreadable = |error: serde_json::Error| {
            if is_binary {
                return FormatError::at(start, &format!("not valid glTF JSON: {error}")).of(path);
            }
            if bytes[start..].iter().find(|byte| !byte.is_ascii_whitespace()) != Some(&b'{') {
                return FormatError("not a glTF file: it begins neither with `glTF` nor with `{`".to_owned()).of(path);
            }
            let text = String::from_utf8_lossy(&bytes[start..]);
            let line = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum::<usize>();
            let at = line + error.column().saturating_sub(1);
            let said = error.to_string();
            let problem = format!("not valid glTF: {}", said.split(" at line ").next().unwrap_or(&said));
            SceneError::Diagnostics(vec![Diagnostic::locate(
                path.to_owned(),
                &text,
                at,
                at + 1,
                problem,
                String::new(),
            )])
        };
        let root: Root = serde_json::from_slice(&bytes[json.clone()]).map_err(unreadable)?;
        let Maps { nodes: maps } = serde_json::from_slice(&bytes[json]).map_err(unreadable)?;
        let version = &root.asset.version;
        if !version.starts_with("2.") {
            return Err(FormatError(format!("glTF {version} is not supported; use glTF 2.0")).of(path));
        }
        let unknown = |name: &&String| !KNOWN.iter().any(|known| name.starts_with(known));
        if let Some(name) = root.extensions_required.iter().find(unknown) {
            return Err(FormatError(format!(
                "the required extension `{name}` is not supported; export the file without it"
            ))
            .of(path));
        }
        let buffers = root.buffers.iter().map(|_| OnceLock::new()).collect();
        Ok(Self { root, maps, path: path.to_owned(), bytes, own, buffers, with_mesh: OnceLock::new() })
    }

    /// Returns the bytes of a view.
    pub(super) fn view(&self, index: Index<View>, of: &str) -> Result<(&View, &[u8]), FormatError> {
        let view = self.get(index, "bufferViews", of)?;
        let name = format!("bufferViews[{}]", index.value());
        let buffer = self.buffer(view.buffer, &name)?;
        let start = view.byte_offset.unwrap_or_default().0;
        let end = start.checked_add(view.byte_length.0);
        let range = end.and_then(|end| Some(usize::try_from(start).ok()?..usize::try_from(end).ok()?));
        let bytes = range.and_then(|range| buffer.get(range)).ok_or_else(|| {
            let (length, has) = (view.byte_length.0, buffer.len());
            FormatError(format!("{name} has {length} bytes from byte {start}, and the buffer has {has}"))
        })?;
        Ok((view, bytes))
    }

    fn buffer(&self, index: Index<Buffer>, of: &str) -> Result<&[u8], FormatError> {
        let buffer = self.get(index, "buffers", of)?;
        let name = format!("buffers[{}]", index.value());
        let bytes = match (&buffer.uri, &self.own) {
            (Some(uri), _) => match self.buffers[index.value()].get_or_init(|| self.resource(uri, &name)) {
                Ok(bytes) => bytes,
                Err(flaw) => return Err(flaw.clone()),
            },
            (None, Some(own)) if index.value() == 0 => &self.bytes[own.clone()],
            _ => return Err(FormatError(format!("{name} has no `uri`, and the file has no binary chunk for it"))),
        };
        let length = buffer.byte_length.0;
        usize::try_from(length)
            .ok()
            .and_then(|length| bytes.get(..length))
            .ok_or_else(|| FormatError(format!("{name} declares {length} bytes, and has {}", bytes.len())))
    }

    /// Returns the data that a `uri` names: bytes in it, or a file in the same folder.
    pub(super) fn resource(&self, uri: &str, of: &str) -> Result<Vec<u8>, FormatError> {
        if let Some(data) = uri.strip_prefix("data:") {
            let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
            let encoded = encoded.ok_or_else(|| FormatError(format!("the data of {of} is not base64")))?;
            return STANDARD
                .decode(encoded)
                .map_err(|error| FormatError(format!("the data of {of} is not valid base64: {error}")));
        }
        let path =
            self.beside(uri).ok_or_else(|| FormatError(format!("{of} refers to `{uri}`, which is not a file")))?;
        // Anything that is not a regular file may have no end.
        if path.exists() && !path.is_file() {
            return Err(FormatError(format!("{of} refers to `{}`, which is not a regular file", path.display())));
        }
        std::fs::read(&path)
            .map_err(|error| FormatError(format!("{of} refers to `{}`, which cannot be read: {error}", path.display())))
    }

    /// Returns the existing files that contain its buffers, except this one.
    pub fn others(&self) -> impl Iterator<Item = PathBuf> {
        let named = self.root.buffers.iter().filter_map(|buffer| self.beside(buffer.uri.as_ref()?));
        named.filter(|path| path.is_file())
    }

    /// Returns the path of the file that a `uri` names; `None` if it names something else.
    pub(super) fn beside(&self, uri: &str) -> Option<PathBuf> {
        let is_elsewhere = uri.starts_with("data:") || uri.contains("://");
        (!is_elsewhere).then(|| self.path.parent().unwrap_or(Path::new("")).join(decoded(uri)))
    }
}

/// Returns the range of the JSON in a binary file, and the range of its buffer.
fn chunks(bytes: &[u8]) -> Result<(Range<usize>, Option<Range<usize>>), FormatError> {
    let number = |at: usize| {
        let four = bytes.get(at..).and_then(|rest| rest.first_chunk());
        four.map(|four| u32::from_le_bytes(*four))
            .ok_or_else(|| FormatError::at(at, "unexpected end of file, expected 4 more bytes"))
    };
    let version = number(4)?;
    if version != 2 {
        return Err(FormatError::at(4, &format!("glTF binary version {version} is not supported; use version 2")));
    }
    let length = number(8)? as usize;
    // Data other than padding after the end would be dropped, or shows that the lengths are wrong.
    if !bytes.get(length..).is_some_and(are_padding) {
        return Err(FormatError::at(
            8,
            &format!("the header declares {length} bytes, and the file has {}", bytes.len()),
        ));
    }
    let (mut at, mut json, mut own) = (12, None, None);
    while at < length {
        let (size, kind) = (number(at)? as usize, number(at + 4)?.to_le_bytes());
        let range = at + 8..at + 8 + size;
        if range.end > length {
            let left = length.saturating_sub(range.start);
            return Err(FormatError::at(at, &format!("a chunk declares {size} bytes, and {left} remain")));
        }
        at = range.end;
        match &kind {
            b"JSON" if json.is_none() => json = Some(range),
            b"BIN\0" if own.is_none() => own = Some(range),
            _ => {}
        }
    }
    json.map(|json| (json, own)).ok_or_else(|| FormatError::at(12, "the file has no JSON chunk"))
}

/// Returns a `uri` with its percent-encoding (%xx) decoded.
fn decoded(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, after @ ..] = rest {
        let digits = after.get(..2).and_then(|digits| std::str::from_utf8(digits).ok());
        let byte = digits.filter(|_| *first == b'%').and_then(|digits| u8::from_str_radix(digits, 16).ok());
        bytes.push(byte.unwrap_or(*first));
        rest = if byte.is_some() { &after[2..] } else { after };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
