//! What pictures say of themselves, read back from their files.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use super::OutputError;
use super::part::said_by_exr;

/// What the picture at `path`, an EXR or a PNG, says under `key`.
///
/// # Errors
///
/// Where it cannot be read, is neither, or does not say it.
pub fn said(path: &Path, key: &str) -> Result<String, OutputError> {
    let is = |name: &str| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(name));
    let text = match () {
        () if is("exr") => said_by_exr(path, key)?,
        () if is("png") => said_by_png(path, key)?,
        () => return Err(OutputError::Format { path: path.to_owned() }),
    };
    text.ok_or_else(|| unsaid(path, format!("it does not say `{key}`, as pictures of this version of `render` do")))
}

fn said_by_png(path: &Path, key: &str) -> Result<Option<String>, OutputError> {
    let file = File::open(path).map_err(|cause| OutputError::Read { path: path.to_owned(), cause })?;
    let broken = |error: png::DecodingError| unsaid(path, format!("this is not a whole PNG: {error}"));
    let reader = png::Decoder::new(BufReader::new(file)).read_info().map_err(broken)?;
    let texts = &reader.info().uncompressed_latin1_text;
    Ok(texts.iter().find(|chunk| chunk.keyword == key).map(|chunk| chunk.text.clone()))
}

fn unsaid(path: &Path, problem: String) -> OutputError {
    OutputError::Part { path: path.to_owned(), problem }
}
