//! Files that are text.

use std::fs::File;
use std::io::{self, Read as _};
use std::path::Path;

use super::{Mistake, SceneError};

/// Reads a file whole, which must be text in UTF-8.
pub fn read_text(path: &Path) -> Result<String, SceneError> {
    let bytes = read_bytes(path)?;
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
    let failed = |source| SceneError::Read { path: path.to_owned(), source };
    let mut file = File::open(path).map_err(failed)?;
    let mut bytes = Vec::new();
    if file.metadata().map_err(failed)?.is_file() {
        file.read_to_end(&mut bytes).map_err(failed)?;
        return Ok(bytes);
    }
    file.take(MOST + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > MOST {
        let problem = "it is no file, and goes on behind 1 GiB: save what it gives in a file";
        return Err(failed(io::Error::new(io::ErrorKind::FileTooLarge, problem)));
    }
    Ok(bytes)
}
