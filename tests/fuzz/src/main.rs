//! Searches for bytes on which the reader named by `READER` fails.
#![no_main]

mod bounds;
mod lines;
mod readers;

use std::sync::OnceLock;

use libfuzzer_sys::fuzz_target;
use readers::{READERS, Reader};

fuzz_target!(|bytes: &[u8]| {
    static CHOSEN: OnceLock<&Reader> = OnceLock::new();
    let chosen = CHOSEN.get_or_init(|| {
        let names: Vec<&str> = READERS.iter().map(|reader| reader.name).collect();
        let name = std::env::var("READER").unwrap_or_default();
        READERS
            .iter()
            .find(|reader| reader.name == name)
            .unwrap_or_else(|| panic!("READER is one of {}", names.join(", ")))
    });
    bounds::within(chosen, bytes);
});
