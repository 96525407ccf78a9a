//! Files that are text.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::OnceLock;

use super::{Mistake, SceneError};

/// Reads a file whole, which must be text in UTF-8.
pub fn read_text(path: &Path) -> Result<String, SceneError> {
    text_of(read_bytes(path)?, path)
}

/// Reads a text that the command line names: a file's, or with `-` that of standard input.
pub fn read_given_text(path: &Path) -> Result<String, SceneError> {
    let name = given_name(path);
    let bytes = read_given(path).map_err(|source| SceneError::Read { path: name.to_owned(), source })?;
    text_of(bytes, name)
}

fn text_of(bytes: Vec<u8>, path: &Path) -> Result<String, SceneError> {
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        // What stands for the byte that is none of UTF-8 is three bytes long, and begins where that did.
        let text = String::from_utf8_lossy(error.as_bytes());
        let (problem, help) = not_text(error.as_bytes());
        SceneError::Mistakes(vec![Mistake::locate(path.to_owned(), &text, at, at + 3, problem, help)])
    })
}

/// What is wrong with bytes that are no text, and what would be right.
fn not_text(bytes: &[u8]) -> (String, String) {
    let known: [(&[u8], &str, &str); 3] = [
        (b"glTF", "glTF, not text", "`bentray import FILE -o scene.toml` makes a scene of it"),
        (b"\x89PNG", "a PNG, not text", "name a scene; what is written goes behind -o"),
        (b"\x76\x2f\x31\x01", "an EXR, not text", "name a scene; what is written goes behind -o"),
    ];
    match known.into_iter().find(|(magic, _, _)| bytes.starts_with(magic)) {
        Some((_, what, help)) => (format!("this is {what}"), help.to_owned()),
        None => ("this byte is no text in UTF-8".to_owned(), "save the file as UTF-8".to_owned()),
    }
}

/// More bytes are not read of what is no file, such as a pipe: it may have no end.
const MOST: u64 = 1 << 30;

/// A file's bytes.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, SceneError> {
    read_file(path).map_err(|source| SceneError::Read { path: path.to_owned(), source })
}

/// The bytes that the command line names: a file's, or with `-` those of standard input. That is read once, and kept for whoever asks
/// again.
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

/// A path as messages name it: standard input has no name of its own.
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

/// What a pipe or a device gives, up to [`MOST`] bytes.
fn read_some(from: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(MOST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MOST {
        let problem = "it is no file, and goes on behind 1 GiB: save what it gives in a file";
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, problem));
    }
    Ok(bytes)
}
