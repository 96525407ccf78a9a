//! File names with a placeholder for the frame number.
//!
//! *Practice.* `{frame}` is the number, and `{frame:4}` has at least four digits. The notations of other programs also work: `####`, with
//! as many digits as signs (at least two), and `%04d`. Both count only in the name of the file, not in names of folders.

use std::path::{Path, PathBuf, is_separator};

/// The largest number of digits that a name may request.
const WIDEST: usize = 20;

/// Returns the path with a frame's number in every placeholder, or `None` without one. The error describes an invalid placeholder.
pub(super) fn numbered(path: &Path, frame: u32) -> Result<Option<PathBuf>, String> {
    let Some(text) = path.to_str() else { return Ok(None) };
    let name = text.rfind(is_separator).map_or(0, |at| at + 1);
    let (mut made, mut rest, mut has_place) = (String::new(), text, false);
    while let Some(at) = rest.find(['{', '#', '%']) {
        made += &rest[..at];
        rest = &rest[at..];
        let is_in_name = text.len() - rest.len() >= name;
        if let Some((length, width)) = place(rest, is_in_name)? {
            has_place = true;
            made.extend(format!("{frame:0width$}").chars());
            rest = &rest[length..];
        } else {
            made += &rest[..1];
            rest = &rest[1..];
        }
    }
    Ok(has_place.then(|| (made + rest).into()))
}

/// Returns the path of a frame; a name without a placeholder is shared by all frames.
pub(super) fn path_of(path: &Path, frame: u32) -> PathBuf {
    numbered(path, frame).ok().flatten().unwrap_or_else(|| path.to_owned())
}

/// Returns the bytes of the placeholder at the start of a text, and its number of digits; `None` if there is no placeholder.
fn place(text: &str, is_in_name: bool) -> Result<Option<(usize, usize)>, String> {
    if let Some(inner) = text.strip_prefix('{') {
        let wrong =
            |length: usize| format!("`{}` is not a valid placeholder: use {{frame}} or {{frame:4}}", &text[..length]);
        let length = inner.find('}').ok_or_else(|| wrong(text.len()))?;
        let (word, width) = inner[..length].split_once(':').unwrap_or((&inner[..length], "0"));
        let width = width.trim().parse().ok().filter(|width| word.trim() == "frame" && *width <= WIDEST);
        return width.map(|width| Some((length + 2, width))).ok_or_else(|| wrong(length + 2));
    }
    if !is_in_name {
        return Ok(None);
    }
    if let Some(inner) = text.strip_prefix('%') {
        let digits = inner.find(|c: char| !c.is_ascii_digit()).unwrap_or(inner.len());
        let width = if digits == 0 { Some(0) } else { inner[..digits].parse().ok().filter(|width| *width <= WIDEST) };
        // A word such as `100%done` is not a placeholder.
        let is_place = inner[digits..].strip_prefix('d').is_some_and(|after| !after.starts_with(char::is_alphanumeric));
        return Ok(width.filter(|_| is_place).map(|width| (digits + 2, width)));
    }
    let signs = text.len() - text.trim_start_matches('#').len();
    Ok((signs > 1).then_some((signs, signs.min(WIDEST))))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(text: &str) -> Result<Option<String>, String> {
        numbered(Path::new(text), 7).map(|path| path.map(|path| path.display().to_string()))
    }

    #[test]
    fn every_place_of_a_number_is_filled() {
        for (text, made) in [
            ("a{frame}.png", "a7.png"),
            ("x{frame}_{frame:2}.png", "x7_07.png"),
            ("{frame:4}/{ frame : 3 }.exr", "0007/007.exr"),
            ("b_{ frame }.png", "b_7.png"),
            ("a_####.png", "a_0007.png"),
            ("a_%04d.png", "a_0007.png"),
            ("a_%d-##.png", "a_7-07.png"),
            ("50%/é#{frame}.png", "50%/é#7.png"),
            ("c##/%d/{frame}.png", "c##/%d/7.png"),
        ] {
            assert_eq!(name(text), Ok(Some(made.to_owned())), "{text}");
        }
        for text in ["a.png", "reel#1.mp4", "100%.png", "100%done.png", "%s.png", "c##/a.png", "frame}.png", ""] {
            assert_eq!(name(text), Ok(None), "{text}");
        }
    }

    #[test]
    fn wrong_places_are_named() {
        for (text, wrong) in [
            ("a{frame:x}.png", "`{frame:x}`"),
            ("a{frame}{n}.png", "`{n}`"),
            ("a{:04}.png", "`{:04}`"),
            ("a{frame:21}.png", "`{frame:21}`"),
            ("a{frame.png", "`{frame.png`"),
            ("a{}.png", "`{}`"),
        ] {
            assert_eq!(
                name(text),
                Err(format!("{wrong} is not a valid placeholder: use {{frame}} or {{frame:4}}")),
                "{text}"
            );
        }
    }
}
