//! Reading text files: one way to read them for scenes, meshes, grids, profiles, laws and tables.
//!
//! *Practice.* A byte-order mark before UTF-8 is removed, `\r` alone may end a line as on old Macs, and UTF-16 is an error that names
//! the encoding. Formats whose comments may be in any encoding are read by [`lenient_text`], all others by [`strict_text`].

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::OnceLock;

use super::{Diagnostic, SceneError};

/// Reads a whole file, which must be UTF-8 text.
pub fn read_text(path: &Path) -> Result<String, SceneError> {
    strict_text(read_bytes(path)?, path)
}

/// Reads the text that the command line names: a file or, for `-`, standard input.
pub fn read_given_text(path: &Path) -> Result<String, SceneError> {
    let name = given_name(path);
    let bytes = read_given(path).map_err(|source| SceneError::Read { path: name.to_owned(), source })?;
    strict_text(bytes, name)
}

/// Returns bytes as text with `\n` at the ends of lines; `path` names them in the error.
///
/// # Errors
///
/// If the bytes are not UTF-8.
pub fn strict_text(mut bytes: Vec<u8>, path: &Path) -> Result<String, SceneError> {
    let mark = bytes.len() - unmarked(&bytes, path)?.len();
    bytes.drain(..mark);
    match String::from_utf8(bytes) {
        Ok(text) => Ok(ended_lines(&text).unwrap_or(text)),
        Err(error) => {
            let at = error.utf8_error().valid_up_to();
            // The character that replaces an invalid byte is three bytes long, and begins at that byte.
            let text = String::from_utf8_lossy(error.as_bytes());
            let (problem, help) = not_text(error.as_bytes());
            Err(SceneError::Diagnostics(vec![Diagnostic::locate(path.to_owned(), &text, at, at + 3, problem, help)]))
        }
    }
}

/// Returns bytes as text with `\n` at the ends of lines; bytes that are not UTF-8 are replaced. `path` names them in the error.
///
/// # Errors
///
/// If the bytes are UTF-16 or UTF-32.
pub fn lenient_text<'a>(bytes: &'a [u8], path: &Path) -> Result<Cow<'a, str>, SceneError> {
    let bytes = unmarked(bytes, path)?;
    let text = String::from_utf8_lossy(bytes);
    Ok(ended_lines(&text).map_or(text, Cow::Owned))
}

/// Returns the bytes after the byte-order mark that some editors write before UTF-8.
///
/// # Errors
///
/// If the bytes are UTF-16 or UTF-32, according to their byte-order mark or their zero bytes.
pub fn unmarked<'a>(bytes: &'a [u8], path: &Path) -> Result<&'a [u8], SceneError> {
    if let Some(rest) = bytes.strip_prefix(b"\xEF\xBB\xBF") {
        return Ok(rest);
    }
    let Some(encoding) = wide_encoding(bytes) else { return Ok(bytes) };
    let problem = format!("the file is encoded as {encoding}, not as UTF-8");
    let help = format!("convert the file to UTF-8, for example with `iconv -f {encoding} -t UTF-8 FILE`");
    Err(SceneError::Diagnostics(vec![Diagnostic::locate(path.to_owned(), "", 0, 0, problem, help)]))
}

/// Returns the encoding of text with several bytes per character, by the name that `iconv` uses.
fn wide_encoding(bytes: &[u8]) -> Option<&'static str> {
    // The byte-order mark of UTF-32LE begins with the mark of UTF-16LE.
    const MARKS: [(&[u8], &str); 4] = [
        (b"\xFF\xFE\0\0", "UTF-32LE"),
        (b"\0\0\xFE\xFF", "UTF-32BE"),
        (b"\xFF\xFE", "UTF-16LE"),
        (b"\xFE\xFF", "UTF-16BE"),
    ];
    // Without a mark, every second byte of ASCII text in UTF-16 is zero.
    // At most `MOST` pairs are checked; fewer than `LEAST` decide nothing.
    const MOST: usize = 16;
    const LEAST: usize = 2;
    if let Some((_, encoding)) = MARKS.iter().find(|(mark, _)| bytes.starts_with(mark)) {
        return Some(encoding);
    }
    let pairs = &bytes.as_chunks::<2>().0[..(bytes.len() / 2).min(MOST)];
    let all = |zero: usize| pairs.len() >= LEAST && pairs.iter().all(|pair| pair[zero] == 0 && pair[1 - zero] != 0);
    [(1, "UTF-16LE"), (0, "UTF-16BE")].into_iter().find(|(zero, _)| all(*zero)).map(|(_, encoding)| encoding)
}

/// Returns the text with `\n` for each `\r` that is not followed by `\n`, or `None` if there is none. All bytes keep their positions.
fn ended_lines(text: &str) -> Option<String> {
    let ends_alone = |at: usize| text.as_bytes().get(at + 1) != Some(&b'\n');
    text.match_indices('\r').find(|(at, _)| ends_alone(*at))?;
    let signs = text.char_indices().map(|(at, sign)| if sign == '\r' && ends_alone(at) { '\n' } else { sign });
    Some(signs.collect())
}

/// Returns the problem with bytes that are not text, and the remedy.
fn not_text(bytes: &[u8]) -> (String, String) {
    let known: [(&[u8], &str, &str); 3] = [
        (b"glTF", "a glTF file, not text", "convert it to a scene with `bentray import FILE -o scene.toml`"),
        (b"\x89PNG", "a PNG image, not text", "give a scene file; name the output with -o"),
        (b"\x76\x2f\x31\x01", "an EXR image, not text", "give a scene file; name the output with -o"),
    ];
    match known.into_iter().find(|(magic, _, _)| bytes.starts_with(magic)) {
        Some((_, what, help)) => (format!("this is {what}"), help.to_owned()),
        None => ("this byte is not valid UTF-8".to_owned(), "save the file as UTF-8".to_owned()),
    }
}

/// The most bytes that are read from anything that is not a regular file, such as a pipe, which may have no end.
const MOST: u64 = 1 << 30;

/// Reads the bytes of a file.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, SceneError> {
    read_file(path).map_err(|source| SceneError::Read { path: path.to_owned(), source })
}

/// Reads the bytes that the command line names: a file or, for `-`, standard input. Standard input is read once and kept for further calls.
pub fn read_given(path: &Path) -> io::Result<Vec<u8>> {
    static INPUT: OnceLock<io::Result<Vec<u8>>> = OnceLock::new();
    if path != Path::new("-") {
        return read_file(path);
    }
    match INPUT.get_or_init(|| read_some(io::stdin().lock())) {
        Ok(bytes) => Ok(bytes.clone()),
        Err(error) => Err(io::Error::new(error.kind(), error.to_string())),
    }
}

/// Returns a path as messages name it; standard input has no path.
#[must_use]
pub fn given_name(path: &Path) -> &Path {
    if path == Path::new("-") { Path::new("standard input") } else { path }
}

fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    let mut file = File::open(path)?;
    if !file.metadata()?.is_file() {
        return read_some(file);
    }
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Reads a pipe or a device, up to [`MOST`] bytes.
fn read_some(from: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(MOST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MOST {
        let problem = "not a regular file, and longer than 1 GiB; save its output to a file first";
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, problem));
    }
    Ok(bytes)
}
