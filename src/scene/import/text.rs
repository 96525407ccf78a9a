//! The text of scene files and of skipped features.

use std::path::Path;

use glam::DVec3;

use crate::document::values::{LARGEST, SMALLEST};

/// Returns a number as text, with the digits of 32 bits unless these move a point too far.
pub(super) fn number(value: f64) -> String {
    /// The largest error of rounding, in scene units.
    const TOO_FAR: f64 = 1e-6;
    let value = if value.is_finite() { value.clamp(-LARGEST, LARGEST) } else { 0.0 };
    let value = if value.abs() < SMALLEST { 0.0 } else { value };
    let rounded = value as f32;
    if (f64::from(rounded) - value).abs() <= TOO_FAR { rounded.to_string() } else { value.to_string() }
}

pub(super) fn vector(value: DVec3) -> String {
    format!("[{}, {}, {}]", number(value.x), number(value.y), number(value.z))
}

/// Returns a color as text, with negative channels set to 0.
pub(super) fn color(value: DVec3) -> String {
    vector(value.max(DVec3::ZERO))
}

/// Returns a string in quotes.
pub(super) fn quoted(text: &str) -> String {
    let escaped = text.chars().map(|sign| match sign {
        '"' => "\\\"".to_owned(),
        '\\' => "\\\\".to_owned(),
        sign if sign.is_control() => format!("\\u{:04X}", u32::from(sign)),
        sign => sign.to_string(),
    });
    format!("\"{}\"", escaped.collect::<String>())
}

/// Returns the key of a table, without quotes if possible.
pub(super) fn key(name: &str) -> String {
    let is_bare = !name.is_empty() && name.chars().all(|sign| sign.is_ascii_alphanumeric() || "-_".contains(sign));
    if is_bare { name.to_owned() } else { quoted(name) }
}

/// Returns the path of a file relative to the folder of the scene.
pub(super) fn relative(path: &Path, folder: &Path) -> String {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let (Ok(file), Ok(folder)) = (path.canonicalize(), folder.canonicalize()) else {
        return path.display().to_string();
    };
    let same = file.components().zip(folder.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(same).map(|_| "..".to_owned());
    let down = file.components().skip(same).map(|part| part.as_os_str().to_string_lossy().into_owned());
    if same == 0 { file.display().to_string() } else { up.chain(down).collect::<Vec<_>>().join("/") }
}

/// The skipped features, each kind once with the items that use it.
#[derive(Default)]
pub(super) struct Left {
    kinds: Vec<(String, Vec<String>)>,
    added: Vec<String>,
}

impl Left {
    /// The largest number of items listed per feature.
    const TOLD: usize = 3;

    /// Records a skipped feature `what` of the item `of`; an empty name is the file.
    pub fn out(&mut self, what: &str, of: &str) {
        let at = self.kinds.iter().position(|(kind, _)| kind == what).unwrap_or_else(|| {
            self.kinds.push((what.to_owned(), Vec::new()));
            self.kinds.len() - 1
        });
        let names = &mut self.kinds[at].1;
        if !of.is_empty() && !names.iter().any(|name| name == of) {
            names.push(of.to_owned());
        }
    }

    /// Records an addition that is not in the file.
    pub fn added(&mut self, what: &str) {
        self.added.push(what.to_owned());
    }

    pub fn said(self) -> Vec<String> {
        let kinds = self.kinds.into_iter().map(|(kind, names)| {
            let told: Vec<String> = names.iter().take(Self::TOLD).map(|name| format!("`{name}`")).collect();
            let more = names.len() - told.len();
            let rest = if more > 0 { format!(" and {more} more") } else { String::new() };
            let of = if told.is_empty() { String::new() } else { format!(" (of {}{rest})", told.join(", ")) };
            format!("not imported: {kind}{of}")
        });
        let added = self.added.into_iter().map(|what| format!("added: {what}"));
        kinds.chain(added).collect()
    }
}
