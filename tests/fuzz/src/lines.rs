//! The source line of an instruction, for libFuzzer's `-print_full_coverage=1`, which calls this function by name. `make
//! fuzz-lines` counts the printed lines.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::path::Path;

/// Writes `format` with the file (`%s`) of the instruction at `at`, and with its file and line (`%l` and `%L`). Of inlined
/// functions it uses the innermost one in this crate. Foreign code is `<null>`, which libFuzzer skips.
#[unsafe(no_mangle)]
extern "C" fn __sanitizer_symbolize_pc(at: *mut c_void, format: *const c_char, to: *mut c_char, size: usize) {
    // SAFETY: libFuzzer passes a text that ends in zero, and room for `size` bytes.
    let (format, to) = unsafe { (CStr::from_ptr(format), std::slice::from_raw_parts_mut(to.cast::<u8>(), size)) };
    let (file, line) = own_line(at).unwrap_or_else(|| ("<null>".to_owned(), 0));
    let place = format!("{file}:{line}");
    let named = [("%s", &file), ("%l", &place), ("%L", &place), ("%F", &String::new()), ("%p", &format!("{at:p}"))];
    let said = named.iter().fold(format.to_string_lossy().into_owned(), |said, (what, is)| said.replace(what, is));
    let length = said.len().min(size - 1);
    to[..length].copy_from_slice(&said.as_bytes()[..length]);
    to[length] = 0;
}

/// Returns 0 if libFuzzer requests a module, because there is only one.
#[unsafe(no_mangle)]
extern "C" fn __sanitizer_get_module_and_offset_for_pc(
    _: *mut c_void,
    _: *mut c_char,
    _: usize,
    _: *mut *mut c_void,
) -> c_int {
    0
}

fn own_line(at: *mut c_void) -> Option<(String, u32)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent()?.parent()?;
    let mut found = None;
    backtrace::resolve(at, |symbol| {
        let own = symbol.filename().and_then(|file| file.strip_prefix(root.join("src")).ok());
        if let (None, Some(file)) = (&found, own) {
            found = symbol.lineno().map(|line| (file.display().to_string(), line));
        }
    });
    found
}
